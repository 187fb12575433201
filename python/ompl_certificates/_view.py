"""Pages that show plans"""

from __future__ import annotations

import html as markup
import os
import pathlib
import shutil
import threading
from typing import Union


class View:
    """A page in which a plan can be looked at, as certificates plan --view writes it. As the value of a cell of a
    notebook it is shown there."""

    def __init__(self, html: str) -> None:
        self.html = html

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Write the page, one file that opens without a network. OSError names a file that cannot be written; what was
        there stays then."""
        file = pathlib.Path(path)
        if file.exists() and not file.is_file():
            file.write_text(self.html, encoding="utf-8")  # a device or a pipe
            return
        target = pathlib.Path(os.path.realpath(file))
        temporary = target.with_name(f".{os.getpid()}.{threading.get_ident()}.html.tmp")
        try:
            temporary.touch()
            if target.exists():
                shutil.copymode(target, temporary)
            temporary.write_text(self.html, encoding="utf-8")
            os.replace(temporary, target)
        except OSError as error:
            raise OSError(error.errno, error.strerror, os.fspath(path)) from error
        finally:
            temporary.unlink(missing_ok=True)

    def _repr_html_(self) -> str:
        # The page has styles and keys of its own, so it gets a frame of its own.
        style = "width: 100%; height: 620px; border: 1px solid #8884; border-radius: 6px"
        return f'<iframe title="plan" style="{style}" srcdoc="{markup.escape(self.html)}"></iframe>'
