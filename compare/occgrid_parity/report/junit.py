"""JUnit XML of a run or of a check, as build servers read it."""

from __future__ import annotations

from xml.etree import ElementTree

from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.compare.run_record import Result, RunRecord
from occgrid_parity.report.run_table import explain_result

UNCHECKED = ("not checked", "grey")


def junit_xml(record: RunRecord) -> str:
    """One test suite per port, one test case per scenario and mode."""
    root = ElementTree.Element(
        "testsuites", {"name": "occgrid-parity", **_counts(record.results)}
    )
    for port in record.ports:
        results = [r for r in record.results if r.port == port.name]
        seconds = sum(
            p.seconds for p in record.processes if p.port == port.name
        )
        suite = ElementTree.SubElement(
            root,
            "testsuite",
            {
                "name": port.name,
                "timestamp": record.started,
                "time": f"{seconds:.3f}",
                **_counts(results),
            },
        )
        for result in results:
            _case(suite, result)
    return _text(root)


def verdict_junit_xml(verdict: Verdict) -> str:
    """One test suite, one test case per level; the whole verdict where one failed."""
    levels = verdict.levels
    counts = {
        "tests": str(len(levels)),
        "failures": str(sum(x.status == "failed" for x in levels)),
        "errors": "0",
        "skipped": str(sum(x.status in UNCHECKED for x in levels)),
    }
    root = ElementTree.Element(
        "testsuites", {"name": "occgrid-parity check", **counts}
    )
    seconds = f"{verdict.seconds:.3f}"
    suite = ElementTree.SubElement(
        root, "testsuite", {"name": verdict.program, "time": seconds, **counts}
    )
    for level in levels:
        _level(suite, verdict, level)
    return _text(root)


def _level(suite: ElementTree.Element, verdict: Verdict, level: Level) -> None:
    case = ElementTree.SubElement(
        suite, "testcase", classname=verdict.program, name=level.title
    )
    if level.status == "failed":
        said = ElementTree.SubElement(
            case,
            "failure",
            message=_xml_text(level.message),
            type=level.word or "failed",
        )
        said.text = _xml_text(verdict_text(verdict))
    elif level.status in UNCHECKED:
        ElementTree.SubElement(case, "skipped", message=level.status)


def _text(root: ElementTree.Element) -> str:
    ElementTree.indent(root)
    text = ElementTree.tostring(root, encoding="unicode", xml_declaration=True)
    return text + "\n"


def _counts(results: list[Result]) -> dict[str, str]:
    def count(*statuses: str) -> str:
        return str(sum(result.status in statuses for result in results))

    return {
        "tests": str(len(results)),
        "failures": count("differs"),
        "errors": count("error", "timeout"),
        "skipped": count("skipped", "left out"),
    }


def _case(suite: ElementTree.Element, result: Result) -> None:
    case = ElementTree.SubElement(
        suite,
        "testcase",
        classname=result.port,
        name=f"{result.scenario}, {result.mode}",
    )
    if result.status == "identical":
        return
    tags = {
        "differs": "failure",
        "skipped": "skipped",
        "left out": "skipped",
    }
    tag = tags.get(result.status, "error")
    said = ElementTree.SubElement(
        case, tag, message=_xml_text(result.reason), type=result.status
    )
    said.text = _xml_text("\n".join(explain_result(result)))


def _xml_text(text: str) -> str:
    """Without the control characters that XML has no way to write."""
    return "".join(c for c in text if c in "\n\t" or ord(c) >= 0x20)
