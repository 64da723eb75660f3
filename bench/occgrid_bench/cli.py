"""The command line."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from occgrid_bench.building import BuildError, build
from occgrid_bench.folders import OUT, WORK
from occgrid_bench.goals import goals
from occgrid_bench.markdown import markdown
from occgrid_bench.parts import PARTS, Options
from occgrid_bench.plots import draw
from occgrid_bench.record import Part, read_part
from occgrid_bench.tables import goals_table, part_table

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False)


def main() -> None:
    """The entry point."""
    app(prog_name="python bench/run.py")


@app.command()
def run(
    quick: Annotated[
        bool, typer.Option("--quick", help="Under two minutes, all parts.")
    ] = False,
    parts: Annotated[
        list[str] | None,
        typer.Option(
            "--part",
            metavar="NAME",
            help=f"Only this part; can be repeated: {', '.join(PARTS)}.",
        ),
    ] = None,
    only: Annotated[
        list[str] | None,
        typer.Option(
            "--only",
            metavar="NAME",
            help="Only this contestant (cpp, java, mrpt, ...); can be repeated.",
        ),
    ] = None,
    rounds: Annotated[
        int | None, typer.Option(min=1, help="How many rounds.")
    ] = None,
    log: Annotated[
        Path | None,
        typer.Option(
            help="A CARMEN log; default: one in $OCCGRID_DATA or ../shared/data."
        ),
    ] = None,
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="For JSON and pictures.")
    ] = OUT,
    build_first: Annotated[
        bool, typer.Option("--build/--no-build", help="Build first.")
    ] = True,
    as_markdown: Annotated[
        bool,
        typer.Option(
            "--markdown",
            help="Measure nothing: the table of what was measured.",
        ),
    ] = False,
) -> None:
    """Measure ports, baselines and peers at the same work, and how time and memory grow."""
    if as_markdown:
        typer.echo(markdown(_known(out)), nl=False)
        return
    console = Console()
    try:
        unknown = [name for name in parts or [] if name not in PARTS]
        if unknown:
            raise ValueError(f"{unknown[0]!r} is none of {', '.join(PARTS)}")
        chosen = parts or list(PARTS)
        with console.status("building") as status:
            if build_first:
                build(ports=True)
            # what is there may be of another version, or of another log
            shutil.rmtree(WORK, ignore_errors=True)
            for name in chosen:
                words = ["make bench", f'BENCH="{_words(name, quick)}"']
                options = Options(
                    quick=quick,
                    rounds=rounds,
                    only=only or [],
                    log=log,
                    command=" ".join(words),
                    say=status.update,
                )
                part = PARTS[name](options)
                if part is not None:
                    part.write(out)
                    console.print(part_table(part))
    except (BuildError, ValueError) as error:
        console.print(f"bench: {error}", markup=False)
        raise typer.Exit(2) from error
    known = {n: p for n, p in _known(out).items() if n in chosen}
    console.print(goals_table(goals(known)))
    for path in [*draw(_known(out), out), *sorted(out.glob("*.json"))]:
        console.print(str(path), markup=False, highlight=False)


def _words(part: str, quick: bool) -> str:
    return f"{'--quick ' if quick else ''}--part {part}"


def _known(folder: Path) -> dict[str, Part]:
    """What was measured, now or before."""
    paths = [folder / f"{name}.json" for name in PARTS]
    return {p.stem: read_part(p) for p in paths if p.exists()}
