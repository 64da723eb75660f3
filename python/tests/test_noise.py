"""noise: Philox's published answers, and what the range noise promises."""

from __future__ import annotations

import numpy as np
import pytest

from occgrid import noise


@pytest.mark.parametrize(
    ("counter", "key", "expected"),
    [
        (
            "00000000 " * 4,
            "00000000 " * 2,
            "6627e8d5 e169c58d bc57ac4c 9b00dbd8",
        ),
        (
            "ffffffff " * 4,
            "ffffffff " * 2,
            "408f276d 41c83b0e a20bc7c6 6d5451fd",
        ),
        (
            "243f6a88 85a308d3 13198a2e 03707344",
            "a4093822 299f31d0",
            "d16cfe09 94fdcceb 5001e420 24126ea1",
        ),
    ],
)
def test_published_answers(counter: str, key: str, expected: str) -> None:
    """The known answers that come with Random123 (Salmon et al. 2011)."""
    words = np.array([[int(w, 16)] for w in counter.split()], dtype=np.uint64)
    k0, k1 = (int(w, 16) for w in key.split())
    answer = noise.philox4x32(words, (k0, k1))[:, 0]
    assert " ".join(f"{w:08x}" for w in answer.tolist()) == expected


def test_a_beam_does_not_depend_on_the_others() -> None:
    many = noise.normal_deviate(7, 3, np.arange(100))
    assert noise.normal_deviate(7, 3, [42])[0] == many[42]
    assert noise.normal_deviate(7, 4, [42])[0] != many[42]
    assert noise.normal_deviate(8, 3, [42])[0] != many[42]


def test_deviates_are_standard_normal() -> None:
    deviates = noise.normal_deviate(1, 0, np.arange(200_000))
    assert abs(deviates.mean()) < 4.0 / 200_000**0.5
    assert abs(deviates.std() - 1.0) < 4.0 / (2 * 200_000) ** 0.5
    inside = [np.mean(np.abs(deviates) < s) for s in (1.0, 2.0, 3.0)]
    np.testing.assert_allclose(inside, [0.6827, 0.9545, 0.9973], atol=0.004)


def test_noisy_ranges_stay_within_the_sensors() -> None:
    ranges = np.array([0.0, 0.001, 5.0, 9.999, 10.0] * 50)
    noisy = noise.add_range_noise(ranges, 0.02, 0, 0, 10.0)
    assert noisy.min() == 0.0
    assert noisy.max() == 10.0
    expected = ranges + 0.02 * noise.normal_deviate(0, 0, np.arange(250))
    inside = (expected > 0.0) & (expected < 10.0)
    assert (noisy[inside] == expected[inside]).all()
