"""The sentences of a verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from occgrid_parity.check.verdict import CaseResult
from occgrid_parity.explain.closeness import Compared
from occgrid_parity.explain.findings import Likely
from occgrid_parity.model.right_formulas import Formulas, other_formulas
from occgrid_parity.model.rounding import Beams

NAMED_BEAMS = 12


def plural(count: int, one: str, many: str | None = None) -> str:
    """``1 beam``, ``2 beams``."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def listed(words: Sequence[str]) -> str:
    """``a``, ``a and b``, ``a, b and c``."""
    if len(words) < 2:
        return "".join(words)
    return ", ".join(words[:-1]) + " and " + words[-1]


def parameters(values: Mapping[str, float]) -> str:
    """``p_occ 0.70 and p_free 0.40``."""
    return listed([f"{name} {value:.2f}" for name, value in values.items()])


def size(shape: tuple[int, ...]) -> str:
    """``220 x 180`` of an array (height, width)."""
    return f"{shape[1]} x {shape[0]}"


def beam_pairs(beams: Beams | None, chosen: Sequence[int]) -> list[list[int]]:
    """[scan, beam] of beams that are counted over all scans."""
    if beams is None:
        return []
    return [[int(beams.scan[i]), int(beams.number[i])] for i in chosen]


def name_beams(pairs: Sequence[Sequence[int]]) -> str:
    """``scan 77 beam 79, scan 78 beam 71``."""
    named = [f"scan {scan} beam {beam}" for scan, beam in pairs[:NAMED_BEAMS]]
    more = len(pairs) - len(named)
    return ", ".join(named) + (f" and {more} more" if more > 0 else "")


def maps_of_scans(scans: str, names: Sequence[str]) -> str:
    """``your maps of a and b are exactly the reference's without the first scan``."""
    different = list(dict.fromkeys(names))
    which = listed(different)
    if len(different) == 1:
        return f"your map of {which} is exactly the reference's {scans}"
    return f"your maps of {which} are exactly the reference's {scans}"


def formula_words(formulas: Formulas) -> str:
    """Which formulas draw the program's map, and whether they are right on other maps, too."""
    named = "; ".join(other_formulas(formulas))
    if formulas.cell == Formulas().cell:
        return f"the reference draws your map with formulas that are as right as its own ({named})"
    return (
        f"the reference draws your map with other formulas ({named}). They are right on this map, but where a pose "
        f"lies exactly on a cell edge, this one for the cell can give the cell beside it: write {Formulas().cell}"
    )


def compared_words(compared: Compared) -> str:
    """How one map compares."""
    said = []
    if compared.status == "differs":
        total = compared.wrong.size
        wrong = int(compared.wrong.sum())
        rounded = int((compared.wrong & ~compared.unexplained).sum())
        told = "this is a mistake, not a rounding effect"
        if compared.together and 0 < rounded < wrong:
            told = f"rounding can explain {rounded} of them, but not the other {wrong - rounded}"
        if compared.left_out:
            told = f"this is exactly the reference's map {compared.left_out}"
        elif not compared.together:
            told = (
                "some beams end on a cell edge, where rounding may choose either side, but we found no such choice "
                "that gives all of your cells"
            )
        verb = "differs" if wrong == 1 else "differ"
        return f"{wrong} of {total} cells {verb}; {told}"
    if compared.status == "edges":
        pairs = beam_pairs(compared.beams, compared.edge_beams)
        said.append(
            "it differs only where a beam ends on a cell edge, and rounding may choose either side "
            f"({name_beams(pairs)})"
        )
        if compared.formulas is not None:
            said.append(formula_words(compared.formulas))
    if compared.halves:
        values = plural(compared.halves, "grey value")
        said.append(
            f"{values} exactly halfway between two levels went the other way"
        )
    if compared.steps is not None:
        said.append(
            "its logarithm has other last bits: it adds "
            f"{compared.steps[0]!r} and {compared.steps[1]!r}, and with these steps every bit is the same"
        )
    return "; ".join(said) or "identical"


def like_rounding(mistake: Likely) -> str:
    """A mistake in rounding that draws all maps, where last bits explain them as well."""
    return (
        f"all your grey values are those of this mistake: {mistake.title} [{mistake.name}]. {mistake.lesson} Last bits "
        "of exp and log can give the same grey values, so it costs no point"
    )


def case_result(
    name: str, mode: str, compared: Compared, seconds: float
) -> CaseResult:
    """The record of one comparison."""
    return CaseResult(
        scenario=name,
        mode=mode,
        status=compared.status,
        seconds=round(seconds, 3),
        message=compared_words(compared),
        cells=int(compared.wrong.sum()),
        total=int(compared.wrong.size),
        halves=compared.halves,
        edge_beams=beam_pairs(compared.beams, compared.edge_beams),
        steps=[]
        if compared.steps is None
        else list(map(repr, compared.steps)),
    )


LESSON_ONLY = "everything but the lesson: the command has no {scenario}, so the program has only the lesson built in"
NO_SEED = "seeded noise: the command has neither {mode} nor {seed}, so the program is taken as noise-free"
ONLY_PIXELS = "pixels only"
NO_YAML = "the YAML beside the map: the program writes none"
PIXELS_ONLY = "log-odds: the program writes no .logodds file, so only pixels are compared"
NO_TWIN = "the well-conditioned lesson, which would tell rounding from error once more"
OWN_NOISE = (
    "the lesson's programs add noise to every range, from a generator that no other language has; if this program "
    "does, too, check it with a standard deviation of 0, or with the noise of SPEC.md section 3.3 and {seed}"
)
