# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, Callable, List, Optional, Sequence, Tuple

def run(
    target: Any,
    argument: int,
    watched: Sequence[Any],
    on_progress: Optional[Callable[[Any, float], Any]],
    interval: float,
    /,
) -> Tuple[bool, List[BaseException]]: ...
def guard() -> None: ...
def set_hooks(configure: Any, refuse: Any, compose: Any, describe: Any, /) -> None: ...
def extend(cls: type, attributes: dict, is_algorithm: bool, /) -> None: ...
