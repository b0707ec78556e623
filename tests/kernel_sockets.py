"""Let the notebooks' kernels answer through files in place of ports.

jupyter_client chooses free ports and lets go of them before the kernel takes them, so that kernels
that start side by side sometimes die. Windows keeps the ports.
"""

import sys
from tempfile import gettempdir
from uuid import uuid4

from jupyter_client.manager import KernelManager

initialize = KernelManager.__init__


def _initialize_with_files(manager, **settings):
    files = f"{gettempdir()}/kernel-{uuid4().hex}"
    initialize(manager, transport="ipc", ip=files, **settings)


if sys.platform != "win32":
    KernelManager.__init__ = _initialize_with_files
