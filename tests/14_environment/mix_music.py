#!/usr/bin/env python3
"""Writes assets/audio/beat.ogg: 26 s of drums, bass and bells, from formulas alone. Needs numpy and oggenc.

    tests/14_environment/mix_music.py assets/audio/beat.ogg

Drums and bass fill the low band, bells the middle one, cymbals the high one. They enter one after the other, so that each
band is heard alone first: bells at 0 s, bass at 4 s, cymbals at 6 s, drums at 8 s. At 20 s all stop but the bells.
"""

import subprocess
import sys
import wave

import numpy

RATE = 44100
BEAT = 0.5  # seconds: 120 beats a minute
LENGTH = 26.0
NOISE = numpy.random.default_rng(14)

# A minor, F, C, G: the root of the bass and three notes above, in semitones from A of 110 Hz.
CHORDS = [(0, (0, 3, 7)), (-4, (-4, 0, 3)), (3, (-2, 3, 7)), (-2, (-2, 2, 5))]


def note(semitones: float, base_hz: float) -> float:
    return base_hz * 2 ** (semitones / 12)


def times(seconds: float):
    return numpy.arange(int(seconds * RATE)) / RATE


def kick():
    t = times(0.45)
    phase = 2 * numpy.pi * (48 * t + 110 / 28 * (1 - numpy.exp(-28 * t)))
    return 0.95 * numpy.sin(phase) * numpy.exp(-7.5 * t) * numpy.minimum(1, t / 0.001)


def snare():
    t = times(0.3)
    body = 0.35 * numpy.sin(2 * numpy.pi * 190 * t) * numpy.exp(-22 * t)
    return body + 0.3 * bright(NOISE.standard_normal(t.size), 0.6) * numpy.exp(-16 * t)


def cymbal(seconds: float, decay: float):
    t = times(seconds)
    return 0.3 * bright(bright(NOISE.standard_normal(t.size), 0.9), 0.9) * numpy.exp(-decay * t) * numpy.minimum(1, (seconds - t) / 0.1)


def bright(samples, share: float):
    """Subtracts a share of the previous sample, which leaves high frequencies."""
    return samples - share * numpy.concatenate(([0], samples[:-1]))


def bass(frequency_hz: float, seconds: float):
    t = times(seconds)
    turn = 2 * numpy.pi * frequency_hz * t
    sound = numpy.sin(turn) + 0.35 * numpy.sin(2 * turn) * numpy.exp(-4 * t) + 0.12 * numpy.sin(3 * turn) * numpy.exp(-8 * t)
    return 0.34 * sound * numpy.minimum(1, t / 0.006) * numpy.minimum(1, (seconds - t) / 0.03)


def bell(frequency_hz: float, seconds: float = 2.4):
    """Two sines, one of which turns the other's phase (J. Chowning, 1973), at the ratio 1 to 3.5 of a small bell."""
    t = times(seconds)
    strike = 2.2 * numpy.exp(-5 * t) * numpy.sin(2 * numpy.pi * 3.5 * frequency_hz * t)
    return 0.2 * numpy.sin(2 * numpy.pi * frequency_hz * t + strike) * numpy.exp(-2.2 * t) * numpy.minimum(1, t / 0.002)


def add(track, at_s: float, sound, pan: float = 0.0):
    """`pan`: -1 left, 1 right, at equal power."""
    first = int(round(at_s * RATE))
    sound = sound[: max(track.shape[1] - first, 0)]
    angle = (pan + 1) * numpy.pi / 4
    track[0, first : first + sound.size] += numpy.cos(angle) * sound
    track[1, first : first + sound.size] += numpy.sin(angle) * sound


def reverberation(track):
    """The track through two seconds of noise that dies away: a hall."""
    t = times(2.0)
    size = 1 << (track.shape[1] + t.size - 1).bit_length()
    wet = numpy.zeros_like(track)
    for side in range(2):
        hall = NOISE.standard_normal(t.size) * numpy.exp(-3.2 * t)
        hall /= numpy.sqrt(numpy.sum(hall**2))
        spectrum = numpy.fft.rfft(track[side], size) * numpy.fft.rfft(hall, size)
        wet[side] = numpy.fft.irfft(spectrum, size)[: track.shape[1]]
    return wet


def mix():
    dry, hall = (numpy.zeros((2, int(LENGTH * RATE))) for _ in range(2))
    for bar in range(11):
        start = 4 * BEAT * bar
        root, chord = CHORDS[bar % 4]
        for i, place in enumerate((0, 0.75, 1.5, 2, 2.75, 3.5)):
            if bar == 10 and place > 0:
                break  # the last one rings alone
            tone = chord[(i * 2 + bar) % 3] + (12 if i % 2 else 0)
            add(hall, start + place * BEAT, bell(note(tone, 440)), (-0.5, 0.4, 0.1)[i % 3])
        if 2 <= bar < 10:
            for place, length in ((0, 0.7), (0.75, 0.5), (1.5, 0.4), (2.5, 0.7), (3.25, 0.4)):
                add(dry, start + place * BEAT, bass(note(root, 55), length * BEAT))
        if 3 <= bar < 10:
            for eighth in range(8):
                loud = 0.9 if eighth % 2 else 0.5
                add(dry, start + eighth * BEAT / 2, loud * cymbal(0.25, 34 if eighth != 7 else 12), 0.25)
        if 4 <= bar < 10:
            for place in (0, 1, 2, 3) if bar % 2 == 0 else (0, 1, 2, 2.5, 3):
                add(dry, start + place * BEAT, kick())
            for place in (1, 3):
                add(dry, start + place * BEAT, snare(), -0.1)
                add(hall, start + place * BEAT, 0.25 * snare(), -0.1)
    add(dry, 8.0, cymbal(2.0, 2.2), -0.3)
    add(dry, 20.0, 1.3 * cymbal(2.5, 2.0), 0.3)
    add(dry, 20.0, kick())
    mixed = dry + hall + 0.55 * reverberation(hall)
    t = times(LENGTH)
    mixed *= numpy.clip((25.5 - t) / 2.5, 0, 1)  # silent for the last half second
    return numpy.tanh(0.9 * mixed)


def main():
    if len(sys.argv) != 2:
        sys.exit(f"usage: {sys.argv[0]} OUTPUT.ogg")
    samples = (32767 * 0.95 * mix().T).round().astype("<i2")
    with wave.open(sys.argv[1] + ".wav", "wb") as file:
        file.setnchannels(2), file.setsampwidth(2), file.setframerate(RATE)
        file.writeframes(samples.tobytes())
    subprocess.run(["oggenc", "-Q", "-q", "4", "-s", "14", "-o", sys.argv[1], sys.argv[1] + ".wav"], check=True)
    subprocess.run(["rm", sys.argv[1] + ".wav"], check=True)


if __name__ == "__main__":
    main()
