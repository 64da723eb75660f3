"""The five exercises of a starter: which functions are to be written, and what each is to do."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Function:
    """A function to be written, by its name in snake case.

    ``snippet`` is where it stands. ``vectors`` says whether the shared vectors have cases of it. A language may lack
    it.
    """

    name: str
    snippet: str
    task: str
    vectors: bool = True


@dataclass(frozen=True)
class Exercise:
    """One stage: its number from 1, its title, its functions, and a scenario that shows the whole of it.

    ``points`` are what the check's levels are worth to a class that does it.
    """

    number: int
    title: str
    functions: tuple[Function, ...]
    scenario: str
    points: tuple[tuple[str, int], ...]


EXERCISES = (
    Exercise(
        1,
        "Log-odds and one cell",
        (
            Function(
                "logit",
                "logit",
                "log(p / (1 - p)), with p kept within [1e-9, 1 - 1e-9]",
            ),
            Function(
                "update_cell",
                "update-cell",
                "add l_update - l0 to the cell, then keep it within "
                "[l_min, l_max]; skip a cell outside the grid",
            ),
            Function(
                "update_cells",
                "update-cell",
                "the same for several cells at once, no cell twice",
                vectors=False,
            ),
        ),
        "saturate",
        (
            ("one-beam", 1),
            ("clamping", 3),
            ("prior", 3),
            ("powers", 1),
            ("lesson", 2),
        ),
    ),
    Exercise(
        2,
        "From the world to the grid",
        (
            Function(
                "world_to_grid",
                "world-to-grid",
                "floor((x - origin_x) / resolution), and likewise for y",
            ),
        ),
        "outside",
        (("one-beam", 1), ("outside", 4), ("twin", 3), ("lesson", 2)),
    ),
    Exercise(
        3,
        "The line of cells",
        (
            Function(
                "bresenham",
                "bresenham",
                "all cells of the line in order, both ends included; "
                "more than 2^20 steps are an error",
            ),
        ),
        "octants",
        (("one-beam", 1), ("octants", 5), ("outside", 2), ("lesson", 2)),
    ),
    Exercise(
        4,
        "One scan",
        (
            Function(
                "read_ranges",
                "read-ranges",
                "distance, hit and used for each range: a hit is below "
                "z_max - 1e-12, NaN is never used",
            ),
            Function(
                "beam_endpoints",
                "beam-endpoints",
                "x + z cos(theta + angle), y + z sin(theta + angle), "
                "with the port's own sine and cosine",
            ),
            Function(
                "update_grid_from_scan",
                "update-grid-from-scan",
                "for each used beam: l_free for the cells before a hit, "
                "l_occ for the hit's cell; l_free for all where nothing "
                "was hit",
                vectors=False,
            ),
        ),
        "one-beam",
        (
            ("one-beam", 2),
            ("no-return", 3),
            ("simulated", 1),
            ("recorded", 2),
            ("lesson", 2),
        ),
    ),
    Exercise(
        5,
        "A whole log",
        (
            Function(
                "map_scenario",
                "map-scenario",
                "a new grid, updated from every scan of the scenario in turn",
                vectors=False,
            ),
        ),
        "lesson",
        (
            ("simulated", 2),
            ("recorded", 2),
            ("mixed", 2),
            ("formats", 1),
            ("lesson", 3),
        ),
    ),
)


def native_name(language: str, name: str) -> str:
    """A function's name as a language writes it."""
    words = name.split("_")
    if language == "java":
        return words[0] + "".join(word.capitalize() for word in words[1:])
    if language == "mathematica":
        return "".join(word.capitalize() for word in words)
    return name


def not_written(exercise: Exercise, name: str) -> str:
    """What a program says that comes to a function that is not written yet."""
    return f"exercise {exercise.number}: {name} is not written yet"
