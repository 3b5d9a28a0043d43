"""Programs side by side: each command in turn by one and the other, so that what else the machine does meets both."""
import dataclasses
import os
import statistics
import subprocess
import time


@dataclasses.dataclass
class Cost:
    wall: float  # s
    cpu: float  # s of user time, of all threads
    memory: float  # MB at most


def once(command, limit):
    """What one run costs; nothing where it takes longer than `limit` seconds or ends with an error."""
    begin = time.monotonic()
    process = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() - begin > limit:
            process.kill()
            os.wait4(process.pid, 0)
            process.returncode = -9
            return None
        time.sleep(0.001)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):
        return None
    return Cost(time.monotonic() - begin, usage.ru_utime, usage.ru_maxrss / 1024)


def side_by_side(programs, arguments, times, limit=900, middle=statistics.median):
    """The median of each cost (or what `middle` is), for each program; nothing for one that failed. `arguments` may be a
    function that makes them anew before each run."""
    costs = [[] for _ in programs]
    for _ in range(times):
        for program, own in zip(programs, costs):
            if None not in own:
                own.append(once([program, *(arguments() if callable(arguments) else arguments)], limit))
    return [None if None in own else
            Cost(*(middle([getattr(cost, field.name) for cost in own]) for field in dataclasses.fields(Cost)))
            for own in costs]
