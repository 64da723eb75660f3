"""JUnit XML says what the record says."""

from __future__ import annotations

from xml.etree import ElementTree

from occgrid_parity.report.junit import junit_xml

from .reported import Ran


def test_every_result_is_a_test_case(ran: Ran) -> None:
    root = ElementTree.fromstring(junit_xml(ran.record))
    suites = {suite.get("name"): suite for suite in root.findall("testsuite")}
    assert list(suites) == ["python", "nearly", "crashes", "absent"]
    counts = {
        name: [
            suite.get(k) for k in ("tests", "failures", "errors", "skipped")
        ]
        for name, suite in suites.items()
    }
    assert counts == {
        "python": ["6", "0", "0", "0"],
        "nearly": ["6", "2", "0", "0"],
        "crashes": ["6", "0", "6", "0"],
        "absent": ["6", "0", "0", "6"],
    }
    assert root.get("tests") == "24"
    failures = suites["nearly"].findall("testcase/failure")
    assert all("gx=5 gy=3" in (failure.text or "") for failure in failures)
    (error, *_) = suites["crashes"].findall("testcase/error")
    assert "<b>no</b>" in (error.text or "")
