"""JUnit XML of a run or of a check, as build servers read it."""

from __future__ import annotations

from junitparser import Error, Failure, JUnitXml, Skipped, TestCase, TestSuite

from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.compare.run_record import Result, RunRecord
from occgrid_parity.report.run_table import explain_result

UNCHECKED = ("not checked", "grey")
KINDS = {"differs": Failure, "skipped": Skipped, "left out": Skipped}


def junit_xml(record: RunRecord) -> str:
    """One test suite per port, one test case per scenario and mode."""
    suites = []
    for port in record.ports:
        suite = TestSuite(port.name)
        suite.timestamp = record.started
        for result in record.results:
            if result.port == port.name:
                suite.add_testcase(_case(result))
        # of the processes, not of the cases: one process maps several scenarios
        suite.time = round(
            sum(p.seconds for p in record.processes if p.port == port.name), 3
        )
        suites.append(suite)
    return _text("occgrid-parity", suites)


def verdict_junit_xml(verdict: Verdict) -> str:
    """One test suite, one test case per level; the whole verdict where one failed."""
    suite = TestSuite(_xml_text(verdict.program))
    for level in verdict.levels:
        suite.add_testcase(_level(verdict, level))
    suite.time = round(verdict.seconds, 3)
    return _text("occgrid-parity check", [suite])


def _case(result: Result) -> TestCase:
    case = TestCase(f"{result.scenario}, {result.mode}", result.port)
    if result.status != "identical":
        kind = KINDS.get(result.status, Error)
        outcome = kind(_xml_text(result.reason), result.status)
        outcome.text = _xml_text("\n".join(explain_result(result)))
        case.result = [outcome]
    return case


def _level(verdict: Verdict, level: Level) -> TestCase:
    case = TestCase(level.title, _xml_text(verdict.program))
    if level.status == "failed":
        outcome = Failure(_xml_text(level.message), level.word or "failed")
        outcome.text = _xml_text(verdict_text(verdict))
        case.result = [outcome]
    elif level.status in UNCHECKED:
        case.result = [Skipped(level.status)]
    return case


def _text(name: str, suites: list[TestSuite]) -> str:
    xml = JUnitXml(name)
    for suite in suites:
        time = suite.time
        suite.update_statistics()  # type: ignore[no-untyped-call]
        suite.time = time
        xml.add_testsuite(suite)
    xml.update_statistics()  # type: ignore[no-untyped-call]
    return str(xml.tostring().decode()) + "\n"  # type: ignore[no-untyped-call]


def _xml_text(text: str) -> str:
    """Without the control characters that XML has no way to write."""
    return "".join(c for c in text if c in "\n\t" or ord(c) >= 0x20)
