"""Mistakes in the noise of simulated ranges (SPEC.md section 3.3)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from occgrid.sensor import Scan
from occgrid_parity.model.arithmetic import (
    TWO_PI,
    box_muller,
    normal_deviate,
    uniforms,
)
from occgrid_parity.model.array_types import Array, Cells
from occgrid_parity.model.mapper_steps import Mapper

NOISE = "section 6.1 (noise is added to every simulated range); SPEC.md section 3.3"


class NoiseOfNextBeam(Mapper):
    name = "noise-of-next-beam"
    title = "each beam gets the noise of the next beam"
    lesson = "Beams are numbered from 0 in the noise's counter."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return super().deviate(seed, scan, beams + 1)


class NoiseOfNextScan(Mapper):
    name = "noise-of-next-scan"
    title = "each scan gets the noise of the next scan"
    lesson = "Scans are numbered from 0 in the noise's counter, in the order of the file."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return super().deviate(seed, scan + 1, beams)


class NoiseOfOneScan(Mapper):
    name = "noise-of-one-scan"
    title = "every scan gets the noise of the first scan"
    lesson = "The noise's counter is (scan, beam, 0, 0): each scan has noise of its own."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return super().deviate(seed, 0, beams)


class NoiseScanAndBeamSwapped(Mapper):
    name = "noise-scan-and-beam-swapped"
    title = "scan and beam are swapped in the noise's counter"
    lesson = "The noise's counter is (scan, beam, 0, 0), the scan first."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return normal_deviate(seed, beams, scan, self.numbers)


class NoiseSeedIgnored(Mapper):
    name = "noise-seed-ignored"
    title = "the seed is not heeded: it is always 0"
    lesson = "The noise's key is (seed, 0): another seed draws other noise."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return super().deviate(0, scan, beams)


class NoiseOfNextSeed(Mapper):
    name = "noise-of-next-seed"
    title = "the noise is that of the next seed"
    lesson = "The noise's key is (seed, 0), with the seed as it was given."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return super().deviate(seed + 1, scan, beams)


class NoiseWithSine(Mapper):
    name = "noise-with-sine"
    title = "the noise takes the sine in place of the cosine"
    lesson = "Box and Muller give two deviates, with cosine and sine; the contract takes the one with the cosine."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        u1, u2, _, _ = uniforms(seed, scan, beams)
        return np.sqrt(-2.0 * self.numbers.log(u1)) * self.numbers.sin(
            TWO_PI * u2
        )


class NoiseOfOtherWords(Mapper):
    name = "noise-of-other-words"
    title = "the noise is made of the last two words"
    lesson = "Of the four words that each counter gives, the first two make the deviate."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        _, _, u3, u4 = uniforms(seed, scan, beams)
        return box_muller(u3, u4, self.numbers)


class NoiseUniformsSwapped(Mapper):
    name = "noise-words-swapped"
    title = "the two words of the noise are swapped"
    lesson = "The first word makes the radius (through the logarithm), the second one the angle."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        u1, u2, _, _ = uniforms(seed, scan, beams)
        return box_muller(u2, u1, self.numbers)


class NoiseOfWholeWords(Mapper):
    name = "noise-of-whole-words"
    title = "the uniform numbers of the noise are (w + 1) / 2^32"
    lesson = (
        "A word w makes the uniform number (w + 0.5) / 2^32. With 1 in place of the half, every range moves by less "
        "than a nanometre, so only a beam that ends beside a cell edge shows it."
    )
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        u1, u2, _, _ = uniforms(seed, scan, beams, part=1.0)
        return box_muller(u1, u2, self.numbers)


class NoiseOnHitsOnly(Mapper):
    name = "noise-on-hits-only"
    title = "a beam that met no wall gets no noise"
    lesson = (
        "Noise is added to every simulated range, as the lesson's programs do; a beam that met nothing can so become "
        "a hit just below the horizon."
    )
    where = NOISE

    def noisy(self, ranges: Array, seed: int, scan: int) -> Array:
        noisy = super().noisy(ranges, seed, scan)
        return np.where(ranges < self.settings.max_range, noisy, ranges)


class NoiseSubtracted(Mapper):
    name = "noise-subtracted"
    title = "the noise is subtracted"
    lesson = "range + noise_std * n, then clamped to [0, max_range]."
    where = NOISE

    def deviate(self, seed: int, scan: int, beams: Cells) -> Array:
        return -super().deviate(seed, scan, beams)


class NoiseVariance(Mapper):
    name = "noise-variance"
    title = "noise_std is taken for the variance"
    lesson = "noise_std is the standard deviation in metres; its square root is not taken."
    where = NOISE

    def noisy(self, ranges: Array, seed: int, scan: int) -> Array:
        deviates = self.deviate(seed, scan, np.arange(ranges.size))
        return self.clip_range(
            ranges + np.sqrt(self.settings.noise_std) * deviates
        )


class NoiseNotClamped(Mapper):
    name = "noise-not-clamped"
    title = "a range with noise may be below 0"
    lesson = "A range with noise is clamped to [0, max_range]. A negative one would put the hit behind the robot."
    where = NOISE

    def clip_range(self, ranges: Array) -> Array:
        return np.minimum(ranges, self.settings.max_range)


class NoNoise(Mapper):
    name = "no-noise"
    title = "there is no noise with a seed either"
    lesson = "With a seed, every simulated range gets noise; only --noise-free leaves ranges as they are."
    where = NOISE

    def noisy(self, ranges: Array, seed: int, scan: int) -> Array:
        return ranges


class NoiseOnRecorded(Mapper):
    name = "noise-on-recorded-scans"
    title = "recorded ranges get noise, too"
    lesson = "Noise makes simulated ranges like measured ones. Recorded ranges are measured; they stay as they are."
    where = NOISE

    def scans(self) -> Iterator[Scan]:
        for number, scan in enumerate(super().scans()):
            if self.seed is not None and isinstance(
                self.world.scans[number], Scan
            ):
                noisy = self.noisy(scan.ranges, self.seed, number)
                yield Scan(scan.pose, scan.angles, noisy)
            else:
                yield scan


class NoiseSimulatedNumberedApart(Mapper):
    name = "simulated-scans-numbered-apart"
    title = "simulated scans are numbered without the recorded ones"
    lesson = "The scans of a scenario are numbered from 0 in the order of the file, simulated and recorded ones alike."
    where = "SPEC.md section 2.3"

    def noisy(self, ranges: Array, seed: int, scan: int) -> Array:
        before = self.world.scans[:scan]
        simulated = sum(not isinstance(one, Scan) for one in before)
        return super().noisy(ranges, seed, simulated)


MISTAKES: tuple[type[Mapper], ...] = (
    NoiseOfNextBeam,
    NoiseOfNextScan,
    NoiseOfOneScan,
    NoiseScanAndBeamSwapped,
    NoiseSeedIgnored,
    NoiseOfNextSeed,
    NoiseWithSine,
    NoiseOfOtherWords,
    NoiseUniformsSwapped,
    NoiseOfWholeWords,
    NoiseOnHitsOnly,
    NoiseSubtracted,
    NoiseVariance,
    NoiseNotClamped,
    NoNoise,
    NoiseOnRecorded,
    NoiseSimulatedNumberedApart,
)
