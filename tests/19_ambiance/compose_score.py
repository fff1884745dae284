#!/usr/bin/env python3
"""Writes the film's score, 212 s: sounds of a sample pack (CC0) and synthesised parts, composed to the cuts of
assets/films/ambiance.film. Needs numpy, ffmpeg (to read the sounds) and oggenc.

    tests/19_ambiance/compose_score.py FOLDER_OF_SOUNDS assets/audio/ambiance.ogg

120 beats a minute: a bar of four beats lasts 2 s, and every cut of the film stands on a bar. The sounds are those that
assets/CREDITS.md names for audio/ambiance.ogg.
"""

import subprocess
import sys
import wave
from pathlib import Path

import numpy

RATE = 44100
LENGTH = 212.0
BEAT = 0.5
NOISE = numpy.random.default_rng(19)

# When the scenes begin, as in the film.
SYSTEM, DAWN, CHRONOSPHERE, JULIA, HEAD, HARBOUR, STATUE, CAR, SPHERE, STREET, LIGHTS, COURTYARD = (
    0, 44, 60, 80, 102, 114, 134, 146, 158, 176, 188, 198)

# D minor, B flat, F, C: roots in semitones from D2, and the notes of the chord above.
CHORDS = [(0, (0, 3, 7, 12)), (-4, (-4, 0, 3, 8)), (3, (-2, 3, 7, 10)), (-2, (-2, 2, 5, 10))]
D2 = 73.416


def hertz(semitones: float, octave: int = 0) -> float:
    return D2 * 2 ** (semitones / 12 + octave)


def times(seconds: float):
    return numpy.arange(int(seconds * RATE)) / RATE


def smooth(x):
    x = numpy.clip(x, 0, 1)
    return x * x * (3 - 2 * x)


def envelope(t, attack: float, length: float, release: float):
    return smooth(t / attack) * smooth((length - t) / release)


class Mix:
    """Two channels, into which sounds are laid at a time."""

    def __init__(self):
        self.sum = numpy.zeros((int(LENGTH * RATE), 2))

    def lay(self, at: float, sound, gain: float = 1.0, pan: float = 0.0):
        first = int(at * RATE)
        if sound.ndim == 1:
            sound = numpy.stack([sound * min(1, 1 - pan), sound * min(1, 1 + pan)], axis=1)
        begin = max(0, -first)
        end = min(len(sound), len(self.sum) - first)
        if end > begin:
            self.sum[first + begin:first + end] += gain * sound[begin:end]

    def echo(self, delay: float, gain: float, times_over: int):
        """Repeats with the sides exchanged: a room larger than the one the sounds were recorded in."""
        step = int(delay * RATE)
        copy = self.sum.copy()
        for i in range(1, times_over + 1):
            copy = copy[:, ::-1]
            self.sum[i * step:] += gain ** i * copy[:len(copy) - i * step]


class Sounds:
    def __init__(self, folder: Path):
        self.folder, self.read = folder, {}

    def __call__(self, name: str, speed: float = 1.0):
        """One channel, its loudest sample 1, played `speed` times as fast."""
        if name not in self.read:
            raw = subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / f"{name}.ogg", "-ac", "1", "-ar",
                                  str(RATE), "-f", "f32le", "-"], check=True, capture_output=True).stdout
            samples = numpy.frombuffer(raw, numpy.float32).astype(float)
            self.read[name] = samples / max(1e-6, numpy.abs(samples).max())
        samples = self.read[name]
        if speed == 1.0:
            return samples
        at = numpy.arange(int(len(samples) / speed)) * speed
        return numpy.interp(at, numpy.arange(len(samples)), samples)


def pad(semitones, seconds: float, bright: float):
    """A chord of strings: for each note seven partials, three voices a little out of tune."""
    t = times(seconds + 2)
    sound = numpy.zeros((len(t), 2))
    for note in semitones:
        for voice, detune in enumerate((-0.06, 0.0, 0.06)):
            phase = 2 * numpy.pi * NOISE.random()
            tone = sum(numpy.sin(2 * numpy.pi * hertz(note + detune, 1) * k * t + k * phase) * bright ** (k - 1) / k
                       for k in range(1, 8))
            sound[:, 0] += tone * (1.2 - 0.5 * voice)
            sound[:, 1] += tone * (0.2 + 0.5 * voice)
    return 0.05 * sound * envelope(t, 0.9, seconds + 2, 2.2)[:, None]


def bass(semitones: float, seconds: float):
    t = times(seconds)
    tone = numpy.sin(2 * numpy.pi * hertz(semitones) * t) + 0.4 * numpy.sin(4 * numpy.pi * hertz(semitones) * t)
    return 0.42 * tone * envelope(t, 0.012, seconds, 0.12)


def pluck(semitones: float, octave: int, seconds: float = 0.9):
    t = times(seconds)
    f = hertz(semitones, octave)
    tone = numpy.sin(2 * numpy.pi * f * t + 1.6 * numpy.exp(-9 * t) * numpy.sin(4 * numpy.pi * f * t))
    return 0.22 * tone * numpy.exp(-4.2 * t) * smooth(t / 0.004)


def kick():
    t = times(0.4)
    return 0.9 * numpy.sin(2 * numpy.pi * (46 * t + 3.6 * (1 - numpy.exp(-32 * t)))) * numpy.exp(-8 * t)


def hat(seconds: float = 0.07):
    t = times(seconds)
    noise = numpy.diff(NOISE.standard_normal(len(t) + 1))
    return 0.10 * noise * numpy.exp(-52 * t)


def clap():
    t = times(0.25)
    noise = NOISE.standard_normal(len(t))
    return 0.16 * noise * (numpy.exp(-22 * t) + 0.7 * numpy.exp(-160 * numpy.abs(t - 0.014)))


def rise(seconds: float):
    """Noise that grows into a cut."""
    t = times(seconds)
    noise = NOISE.standard_normal(len(t))
    low = numpy.convolve(noise, numpy.ones(24) / 24, "same")
    share = t / seconds
    return 0.32 * (low * (1 - share) + 0.4 * noise * share) * share ** 2.5


def chords(mix: Mix, begin: float, end: float, bright: float, gain: float, bar: float = 4.0):
    at, i = begin, 0
    while at < end:
        root, notes = CHORDS[i % 4]
        mix.lay(at, pad(notes, min(bar, end - at), bright), gain)
        at, i = at + bar, i + 1


def arpeggio(mix: Mix, begin: float, end: float, gain: float, octave: int = 2, step: float = BEAT / 2, bar: float = 4.0):
    pattern = (0, 1, 2, 3, 2, 1, 3, 2)
    for i in range(int(round((end - begin) / step))):
        at = begin + i * step
        notes = CHORDS[int((at - begin) / bar) % 4][1]
        mix.lay(at, pluck(notes[pattern[i % 8]], octave + (i % 16 >= 12)), gain * (1.0 if i % 4 == 0 else 0.7),
                0.5 * numpy.sin(0.7 * i))


def beat(mix: Mix, begin: float, end: float, gain: float, full: bool, bar: float = 4.0):
    for i in range(int(round((end - begin) / BEAT))):
        at = begin + i * BEAT
        root = CHORDS[int((at - begin) / bar) % 4][0]
        mix.lay(at, kick(), gain)
        mix.lay(at + BEAT / 2, bass(root, 0.23), gain)
        mix.lay(at + BEAT / 2, hat(), gain, 0.3)
        if full:
            mix.lay(at + 0.75 * BEAT, bass(root + (12 if i % 4 == 3 else 0), 0.11), 0.8 * gain)
            mix.lay(at + BEAT / 4, hat(0.04), 0.6 * gain, -0.3)
            mix.lay(at + 3 * BEAT / 4, hat(0.04), 0.6 * gain, -0.3)
            if i % 2 == 1:
                mix.lay(at, clap(), gain)


def long_notes(mix: Mix, begin: float, end: float, gain: float, bar: float = 4.0):
    at, i = begin, 0
    while at < end:
        mix.lay(at, bass(CHORDS[i % 4][0], min(bar, end - at) - 0.05), gain)
        at, i = at + bar, i + 1


def compose(sounds: Sounds):
    far, near = Mix(), Mix()
    # The void: a drone, bells at each planet (every 4 s), a choir from Jupiter on.
    for at in range(0, 44, 8):
        far.lay(at, sounds("ambi_drone", 0.8) * envelope(times(len(sounds("ambi_drone", 0.8)) / RATE), 1.0, 12, 3)
                [:len(sounds("ambi_drone", 0.8))], 0.5)
    chords(far, 0, 44, 0.35, 0.7, 8.0)
    for i, at in enumerate(range(4, 44, 4)):
        far.lay(at, sounds("elec_bell", (1.0, 1.189, 0.891, 1.335)[i % 4]), 0.28, 0.6 * (-1) ** i)
        near.lay(at - 1.4, sounds("ambi_swoosh"), 0.25, -0.6 * (-1) ** i)
    for at in (20, 28, 36):
        far.lay(at, sounds("ambi_choir", 0.75), 0.30)
    near.lay(DAWN - 4, rise(4.0), 0.9)
    near.lay(DAWN, sounds("bd_boom", 0.7), 0.9)
    near.lay(DAWN, sounds("drum_cymbal_open", 0.8), 0.35)
    # Dawn: the chords open, piano.
    chords(far, DAWN, CHRONOSPHERE, 0.6, 1.0)
    long_notes(near, DAWN, CHRONOSPHERE, 0.35)
    for i, at in enumerate(range(DAWN, CHRONOSPHERE, 4)):
        far.lay(at, sounds("ambi_piano", (1.0, 0.794, 1.189, 0.891)[i % 4]), 0.5)
    # The chronosphere: glass, a pulse.
    chords(far, CHRONOSPHERE, JULIA, 0.45, 0.8)
    for at in range(CHRONOSPHERE, JULIA, 4):
        far.lay(at, sounds("ambi_glass_hum", 0.9), 0.4, 0.4)
        far.lay(at + 2, sounds("ambi_glass_rub"), 0.3, -0.4)
    arpeggio(far, CHRONOSPHERE + 4, JULIA, 0.55, 2, BEAT)
    for i in range(int((JULIA - CHRONOSPHERE - 4) / 2)):
        near.lay(CHRONOSPHERE + 4 + 2 * i, sounds("bd_808"), 0.7)
    near.lay(JULIA - 2, rise(2.0), 0.6)
    # Julia: everything moves.
    chords(far, JULIA, HEAD - 2, 0.6, 0.8)
    arpeggio(far, JULIA, HEAD - 2, 0.8)
    beat(near, JULIA + 4, HEAD - 2, 0.62, False)
    near.lay(HEAD - 2, sounds("ambi_dark_woosh"), 0.5)
    # The head: one choir, close.
    for at in (HEAD, HEAD + 6):
        far.lay(at, sounds("ambi_choir", 0.6), 0.42)
    chords(far, HEAD, HARBOUR, 0.25, 0.8, 6.0)
    for at in range(HEAD + 2, HARBOUR, 4):
        near.lay(at, sounds("bass_woodsy_c", 0.56), 0.35)
    # The harbour: piano over water.
    chords(far, HARBOUR, STATUE, 0.5, 1.0)
    arpeggio(far, HARBOUR + 4, STATUE, 0.4, 3, BEAT)
    long_notes(near, HARBOUR, STATUE, 0.3)
    for i, at in enumerate(range(HARBOUR, STATUE, 4)):
        far.lay(at, sounds("ambi_piano", (0.794, 1.0, 0.891, 1.189)[i % 4]), 0.4, 0.3)
    for at in range(HARBOUR + 8, STATUE):
        near.lay(at, sounds("bd_haus"), 0.5)
    near.lay(STATUE - 2, rise(2.0), 0.8)
    # Statue, car, sphere: the full beat, and the sphere hears it alone for four bars.
    for begin, end, gain in ((STATUE, CAR, 0.7), (CAR, SPHERE, 0.75), (SPHERE + 4, STREET, 0.8)):
        near.lay(begin, sounds("drum_cymbal_open"), 0.4)
        beat(near, begin, end, gain, True)
        chords(far, begin, end, 0.6, 0.7)
        arpeggio(far, begin, end, 0.7)
    near.lay(SPHERE, sounds("bass_drop_c", 0.6), 0.8)
    for i in range(8):
        near.lay(SPHERE + i * BEAT, kick(), 0.8)
    far.lay(SPHERE, sounds("ambi_lunar_land"), 0.4)
    for i in range(9):
        far.lay(SPHERE + 4 + 1.5 * i, sounds("perc_bell", 1.0 + 0.12 * (i % 4)), 0.16, 0.5 * (-1) ** i)
    # Street and lights: the beat goes on without its chords, which come back with the lights.
    beat(near, STREET, LIGHTS, 0.72, True)
    for at in range(STREET, LIGHTS, 2):
        far.lay(at, sounds("elec_twang", 0.89), 0.25, 0.5)
    near.lay(LIGHTS - 4, rise(4.0), 0.8)
    near.lay(LIGHTS, sounds("drum_cymbal_open", 0.9), 0.5)
    beat(near, LIGHTS, COURTYARD, 0.8, True)
    chords(far, LIGHTS, COURTYARD, 0.75, 1.0)
    arpeggio(far, LIGHTS, COURTYARD, 0.8, 3)
    # The courtyard: a bell for each layer of the G-buffer, a second each, then the last chord.
    for i in range(6):
        near.lay(COURTYARD + i, sounds("elec_chime", 1.0 + 0.06 * i), 0.4, 0.5 * (-1) ** i)
        near.lay(COURTYARD + i, kick(), 0.7)
    near.lay(COURTYARD + 6, sounds("bd_boom", 0.7), 0.9)
    near.lay(COURTYARD + 6, sounds("drum_cymbal_soft", 0.8), 0.4)
    far.lay(COURTYARD + 6, pad((0, 3, 7, 12, 14), 5.5, 0.6), 1.3)
    far.lay(COURTYARD + 6, sounds("ambi_choir", 0.75), 0.35)
    far.lay(COURTYARD + 6, bass(0, 5.5), 0.6)

    far.echo(0.375, 0.42, 5)
    mixed = 0.8 * far.sum + near.sum
    seconds = numpy.arange(len(mixed)) / RATE
    mixed *= (smooth(seconds / 2.0) * smooth((LENGTH - seconds) / 4.0))[:, None]
    # Louder passages are held back: no sample leaves -1 to 1.
    return numpy.tanh(1.9 * mixed)


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_SOUNDS OUTPUT.ogg")
    mixed = compose(Sounds(Path(sys.argv[1])))
    with wave.open(sys.argv[2] + ".wav", "wb") as file:
        file.setnchannels(2), file.setsampwidth(2), file.setframerate(RATE)
        file.writeframes((32000 * mixed).astype("<i2").tobytes())
    subprocess.run(["oggenc", "-Q", "-q", "3", "-s", "19", "-o", sys.argv[2], sys.argv[2] + ".wav"], check=True)
    Path(sys.argv[2] + ".wav").unlink()


if __name__ == "__main__":
    main()
