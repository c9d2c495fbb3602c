"""Where files are: a folder of this machine, or any store that fsspec knows, such as `s3://bucket/folder`."""
import errno
import os
import posixpath
import shutil
import tempfile
from dataclasses import dataclass

import fsspec

UNFINISHED = ".unfinished-"


@dataclass(frozen=True)
class Entry:
    """A file of a place: its path there, its size in bytes, and a text that changes when the file does."""

    path: str
    size: int
    stamp: str


class Place:
    """A folder. It is small when it is sent to a worker: the store is opened there.

    url: a path, or a URL of fsspec. options: for the store, such as `endpoint_url`.
    """

    def __init__(self, url, options=None):
        self.url, self.options = url, options or {}

    def __reduce__(self):
        return Place, (self.url, self.options)

    @property
    def store(self):
        if not hasattr(self, "_store"):
            self._store, self._root = fsspec.core.url_to_fs(self.url, **self.options)
            # A listing that is remembered would hide what other machines write.
            self._store.use_listings_cache = False
        return self._store

    def at(self, path=""):
        """The full path in the store."""
        self.store
        return posixpath.join(self._root, path) if path else self._root

    @property
    def is_local(self):
        return "file" in (self.store.protocol if isinstance(self.store.protocol, tuple) else (self.store.protocol,))

    def list(self):
        """All files, in the order of their paths; hidden ones are left out."""
        self.store.invalidate_cache()
        found = []
        for path, about in self.store.find(self.at(), detail=True).items():
            own = path[len(self.at()):].lstrip("/")
            if any(part.startswith(".") for part in own.split("/")):
                continue
            changed = about.get("ETag") or about.get("mtime") or about.get("LastModified") or about.get("created") or ""
            found.append(Entry(own, about["size"], f"{about['size']} {changed}"))
        return sorted(found, key=lambda one: one.path)

    def fetch(self, path, target):
        """Brings a file to this machine. A file of a local place is linked where it can be, which costs nothing."""
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if not self.is_local:
            return self.store.get_file(self.at(path), target)
        try:
            os.link(self.at(path), target)
        except OSError:
            shutil.copyfile(self.at(path), target)

    def read(self, path):
        return self.store.cat_file(self.at(path))

    def exists(self, path):
        return self.store.exists(self.at(path))

    def write(self, path, data):
        """Writes a file as a whole: a reader sees the one before, or this one."""
        if not self.is_local:
            return self.store.pipe_file(self.at(path), data)
        target = self.at(path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        handle, beside = tempfile.mkstemp(prefix=UNFINISHED, dir=os.path.dirname(target))
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            os.chmod(beside, 0o644)
            os.replace(beside, target)
        except BaseException:
            os.unlink(beside)
            raise

    def take_folder(self, folder, name):
        """Writes a folder of this machine as a whole. Object stores have no folders: there its page comes last."""
        if not self.is_local:
            names = sorted(os.listdir(folder), key=lambda one: one == "index.html")
            for one in names:
                self.store.put_file(os.path.join(folder, one), self.at(f"{name}/{one}"))
            return
        root = self.at()
        os.makedirs(root, exist_ok=True)
        beside = tempfile.mkdtemp(prefix=UNFINISHED, dir=root)
        try:
            whole = os.path.join(beside, "new")
            os.mkdir(whole)
            for one in os.listdir(folder):
                _copy(os.path.join(folder, one), os.path.join(whole, one))
            target = os.path.join(root, name)
            # Another worker may write the same scan: both have the same bytes.
            for _ in range(5):
                try:
                    if os.path.isdir(target):
                        os.rename(target, tempfile.mkdtemp(prefix="old-", dir=beside) + "/old")
                    os.rename(whole, target)
                    break
                except OSError as error:
                    if error.errno not in (errno.EEXIST, errno.ENOTEMPTY, errno.ENOENT):
                        raise
        finally:
            shutil.rmtree(beside, ignore_errors=True)

    def remove(self, name):
        """Removes a folder or a file as a whole; nothing where it is gone."""
        if not self.store.exists(self.at(name)):
            return
        if not self.is_local:
            return self.store.rm(self.at(name), recursive=True)
        beside = tempfile.mkdtemp(prefix=UNFINISHED, dir=self.at())
        os.rename(self.at(name), os.path.join(beside, "old"))
        shutil.rmtree(beside)

    def remove_unfinished(self):
        """What a worker that was killed has left. Call it while no other run writes there."""
        if self.is_local and os.path.isdir(self.at()):
            for name in os.listdir(self.at()):
                if name.startswith(UNFINISHED):
                    path = os.path.join(self.at(), name)
                    shutil.rmtree(path) if os.path.isdir(path) else os.unlink(path)


def _copy(source, target):
    """The bytes are on the disk before the ledger says so."""
    with open(source, "rb") as file, open(target, "wb") as copy:
        shutil.copyfileobj(file, copy)
        copy.flush()
        os.fsync(copy.fileno())
