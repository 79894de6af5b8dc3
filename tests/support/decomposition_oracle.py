#!/usr/bin/env python3
"""Modal decompositions by NumPy, written from the published definitions, for comparison with
`pennon decompose` on the same file.

usage: decomposition_oracle.py FILE.h5 METHOD [KEY=VALUE ...]     one JSON object on standard output

METHOD  pod   Sirovich (1987): eigenvalues of the snapshots' products
        dmd   Tu, Rowley, Luchtenburg, Brunton & Kutz (2014), algorithm 2; rank=R; of weights
              that change with time their mean
        spod  Towne, Schmidt & Colonius (2018), algorithm 1; block=N overlap=S window=hamming|hann|none
KEY     mean=removed|kept, and those above. The file has q (M, n) or (M, c, n), t (M), and perhaps
        weight (n) or (M, n).
"""
import json
import sys

import h5py
import numpy as np


def weighted_snapshots(name, mean, has_mean_weight):
    """W^1/2 q, a column for each time, and the time step."""
    with h5py.File(name) as file:
        t = file["t"][()].astype(float)
        q = file["q"][()]
        weight = file["weight"][()].astype(float) if "weight" in file else np.ones(q.shape[-1])
    q = q.astype(complex) if np.iscomplexobj(q) else q.astype(float)
    if q.ndim == 2:
        q = q[:, None, :]
    if weight.ndim == 1:
        weight = np.broadcast_to(weight, (len(t), q.shape[2]))
    if has_mean_weight:
        weight = np.broadcast_to(weight.mean(axis=0), weight.shape)
    if mean == "removed":
        q = q - q.mean(axis=0)
    weighted = np.sqrt(weight)[:, None, :] * q
    return weighted.reshape(len(t), -1).T, (t[-1] - t[0]) / (len(t) - 1)


def pod(snapshots):
    energy = np.linalg.eigvalsh(snapshots.conj().T @ snapshots / snapshots.shape[1])[::-1]
    return {"energy": energy.tolist()}


def dmd(snapshots, dt, rank):
    x, y = snapshots[:, :-1], snapshots[:, 1:]
    u, s, vh = np.linalg.svd(x, full_matrices=False)
    u, s, v = u[:, :rank], s[:rank], vh[:rank].conj().T
    reduced = u.conj().T @ y @ v / s
    theta, w = np.linalg.eig(reduced)
    modes = y @ (v / s) @ w / theta
    modes = modes / np.linalg.norm(modes, axis=0)
    amplitude = np.linalg.lstsq(modes, snapshots[:, 0].astype(complex), rcond=None)[0]
    exponents = np.log(theta) / dt
    order = np.lexsort((exponents.imag, exponents.real))
    return {"growth": exponents.real[order].tolist(), "omega": exponents.imag[order].tolist(),
            "amplitude": abs(amplitude)[order].tolist()}


def spod(snapshots, dt, length, overlap, window):
    m = np.arange(length) / (length - 1)
    w = {"hamming": 0.54 - 0.46 * np.cos(2 * np.pi * m), "hann": 0.5 - 0.5 * np.cos(2 * np.pi * m),
         "none": np.ones(length)}[window]
    w = w / np.sqrt(np.mean(w**2))
    step = max(length - int(np.floor(overlap * length)), 1)
    firsts = range(0, snapshots.shape[1] - length + 1, step)
    is_real = not np.iscomplexobj(snapshots)
    blocks = np.array([np.fft.fft(w * snapshots[:, first:first + length], axis=1) for first in firsts])
    blocks *= np.sqrt(dt / length)
    f = np.fft.fftfreq(length, dt)
    count = length // 2 + 1 if is_real else length
    energy = []
    for k in range(count):
        q = blocks[:, :, k].T
        values = np.linalg.eigvalsh(q.conj().T @ q / len(firsts))[::-1][:min(q.shape)]
        alone = k == 0 or 2 * k == length
        energy.append((values * (1 if alone or not is_real else 2)).tolist())
    order = range(count) if is_real else np.argsort(f)
    f, energy = [abs(f[k]) if is_real else f[k] for k in order], [energy[k] for k in order]
    return {"f": f, "energy": energy, "blocks": len(firsts)}


def main():
    name, method = sys.argv[1:3]
    keys = dict(item.split("=", 1) for item in sys.argv[3:])
    mean = keys.get("mean", "kept" if method == "dmd" else "removed")
    snapshots, dt = weighted_snapshots(name, mean, method == "dmd")
    if method == "pod":
        found = pod(snapshots)
    elif method == "dmd":
        found = dmd(snapshots, dt, int(keys["rank"]))
    else:
        found = spod(snapshots, dt, int(keys.get("block", 128)), float(keys.get("overlap", 0.5)),
                     keys.get("window", "hamming"))
    print(json.dumps(found))


main()
