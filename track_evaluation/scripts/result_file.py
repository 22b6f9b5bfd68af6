"""Files of results: whole or not at all."""
import contextlib
import os
import pathlib
import stat
import tempfile


def write(path, text, inputs=()):
    """Writes a file beside its place and renames it. Raises OSError where something stands that is no regular file, or an input."""
    path = pathlib.Path(path)
    with contextlib.suppress(FileNotFoundError):
        there = path.lstat()
        if not stat.S_ISREG(there.st_mode):
            raise OSError(f"{path}: cannot be written: it exists and is no regular file")
        if any(os.path.samestat(there, os.stat(name)) for name in inputs if os.path.exists(name)):
            raise OSError(f"{path}: is the input itself; name another file")
    number, part = tempfile.mkstemp(prefix=".tws-", suffix=".part", dir=path.parent)
    try:
        with open(number, "w", encoding="utf-8") as file:
            file.write(text)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(part, 0o666 & ~umask)
        os.replace(part, path)
    except OSError as error:
        os.unlink(part)
        raise OSError(f"{path}: cannot be written: {error.strerror}") from error
