"""portable_math: the bits of Java's StrictMath; compare/ checks many more arguments."""

from __future__ import annotations

import math

import numpy as np
import pytest

from occgrid import portable_math

FUNCTIONS = {
    name: getattr(portable_math, name) for name in ("sin", "cos", "exp", "log")
}


def bits(x: float) -> str:
    return f"{int(np.float64(x).view(np.uint64)):016x}"


@pytest.mark.parametrize(
    ("function", "argument", "expected"),
    [
        ("sin", 0.5, "3fdeaee8744b05f0"),
        ("sin", -0.0, "8000000000000000"),
        ("sin", 1.0, "3feaed548f090cee"),
        ("sin", -2.5, "bfe326af0dcfcab0"),
        ("sin", 3.141592653589793, "3ca1a62633145c07"),
        ("sin", 1.5707963267948966, "3ff0000000000000"),
        ("sin", -11.0, "3fefffeb762e93eb"),
        ("sin", 100000.0, "3fa24daa9c527e96"),
        ("sin", 823549.7, "3fa22140dd53ef94"),
        ("sin", 1e22, "bfeb453ab76bf397"),
        ("sin", 1.7976931348623157e308, "3f7452fc98b34e97"),
        ("sin", 5.319372648326541e255, "3ff0000000000000"),
        ("sin", 5e-324, "0000000000000001"),
        ("cos", 0.5, "3fec1528065b7d50"),
        ("cos", 0.0, "3ff0000000000000"),
        ("cos", 1.0, "3fe14a280fb5068c"),
        ("cos", -2.5, "bfe9a2f7ef858b7d"),
        ("cos", 3.141592653589793, "bff0000000000000"),
        ("cos", 1.5707963267948966, "3c91a62633145c07"),
        ("cos", -11.0, "3f7220ae41ee2fdf"),
        ("cos", 100000.0, "bfeffac3841b3da7"),
        ("cos", 823549.7, "3feffadcd0a99d64"),
        ("cos", 1e22, "3fe0be2cef01c8f4"),
        ("cos", 1.7976931348623157e308, "bfefffe62ecfab75"),
        ("cos", 5.319372648326541e255, "bc214ae72e6ba22f"),
        ("cos", 0.79, "3fe685e69c8569af"),
        ("exp", 0.0, "3ff0000000000000"),
        ("exp", 1.0, "4005bf0a8b14576a"),
        ("exp", -1.0, "3fd78b56362cef38"),
        ("exp", 0.25, "3ff48b5e3c3e8186"),
        ("exp", 1e-09, "3ff000000044b830"),
        ("exp", 709.782712893384, "7fefffffffffff2a"),
        ("exp", 709.7827128933841, "7ff0000000000000"),
        ("exp", -708.5, "000e6cf6d08897ac"),
        ("exp", -745.1332191019411, "0000000000000001"),
        ("exp", -745.1332191019412, "0000000000000000"),
        ("exp", 1e-300, "3ff0000000000000"),
        ("log", 1.0, "0000000000000000"),
        ("log", 0.5, "bfe62e42fefa39ef"),
        ("log", 3.0, "3ff193ea7aad030a"),
        ("log", 1e-09, "c034b927f32bffb8"),
        ("log", 5e-324, "c0874385446d71c3"),
        ("log", 1.7976931348623157e308, "40862e42fefa39ef"),
        ("log", 1.0000001, "3e7ad7f2847b6492"),
        ("log", 0.9999999, "be7ad7f2b1049b9f"),
        ("log", 2.718281828459045, "3ff0000000000000"),
        ("log", 4.35, "3ff785d71b613825"),
        ("log", 0.7, "bfd6d3c324e13f50"),
    ],
)
def test_bits_of_strict_math(
    function: str, argument: float, expected: str
) -> None:
    assert bits(FUNCTIONS[function](argument)) == expected


@pytest.mark.parametrize("argument", [math.inf, -math.inf, math.nan])
def test_sin_and_cos_of_no_angle(argument: float) -> None:
    assert math.isnan(portable_math.sin(argument))
    assert math.isnan(portable_math.cos(argument))


def test_limits_of_exp_and_log() -> None:
    assert portable_math.exp(math.inf) == math.inf
    assert bits(float(portable_math.exp(-math.inf))) == bits(0.0)
    assert math.isnan(portable_math.exp(math.nan))
    assert portable_math.log(math.inf) == math.inf
    assert portable_math.log(0.0) == -math.inf
    assert portable_math.log(-0.0) == -math.inf
    assert math.isnan(portable_math.log(-1.0))
    assert math.isnan(portable_math.log(math.nan))


@pytest.mark.parametrize("function", FUNCTIONS)
def test_an_array_gives_what_its_numbers_give(function: str) -> None:
    rng = np.random.default_rng(3)
    x = rng.uniform(-30.0, 30.0, (40, 25))
    whole = FUNCTIONS[function](x)
    single = [[float(FUNCTIONS[function](v)) for v in row] for row in x]
    assert whole.tobytes() == np.array(single).tobytes()


@pytest.mark.parametrize("function", FUNCTIONS)
def test_close_to_the_platform(function: str) -> None:
    """Not the contract: a guard against a slip that the known bits miss."""
    x = np.random.default_rng(4).uniform(0.01, 700.0, 1000)
    expected = getattr(np, function)(x)
    np.testing.assert_allclose(FUNCTIONS[function](x), expected, rtol=1e-12)
