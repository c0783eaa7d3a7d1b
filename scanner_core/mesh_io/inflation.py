"""Decompression of the blocks of a VTP file, each to a size that is known before and never exceeded."""

from __future__ import annotations

import lzma
import zlib

from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkIOCore import vtkLZ4DataCompressor

from scanner_core.mesh_io.malformed import MalformedError

COMPRESSORS = ("vtkZLibDataCompressor", "vtkLZMADataCompressor", "vtkLZ4DataCompressor")
_HIGHEST_RATIO = {"vtkZLibDataCompressor": 1100, "vtkLZMADataCompressor": 10_000, "vtkLZ4DataCompressor": 260}


def inflated(compressor: str, content: bytes, size: int, name: str) -> bytes:
    """`content` decompressed to exactly `size` bytes; MalformedError naming the array `name` otherwise."""
    damaged = MalformedError(f"{name} has a damaged block")
    if size > _HIGHEST_RATIO[compressor] * (len(content) + 16):
        raise damaged
    try:
        if compressor == "vtkZLibDataCompressor":
            result = zlib.decompressobj().decompress(content, size) if size else b""
        elif compressor == "vtkLZMADataCompressor":
            result = lzma.LZMADecompressor(memlimit=256 << 20).decompress(content, size) if size else b""
        else:
            result = _lz4(content, size)
    except (zlib.error, lzma.LZMAError, EOFError):
        raise damaged from None
    if len(result) != size:
        raise damaged
    return result


def _lz4(content: bytes, size: int) -> bytes:
    codec = vtkLZ4DataCompressor()
    codec.AddObserver(vtkCommand.ErrorEvent, lambda *_: None)  # otherwise VTK prints; what is wrong is told by the size
    room = bytearray(size)
    written = codec.Uncompress(content, len(content), room, size)
    return bytes(room[:written])
