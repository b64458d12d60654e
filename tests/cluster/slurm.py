"""A Slurm of one node on this machine, for tests: its own keys, ports, folders; nothing is left behind."""

import ctypes
import os
import pathlib
import secrets
import shutil
import signal
import socket
import subprocess
import tempfile
import time

CONFIGURATION = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
KillWait=5
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MaxArraySize=1001
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class CannotStart(Exception):
    """Slurm cannot be started here; the reason."""


def end_with_parent():
    """Where the test itself is killed, nothing of Slurm outlives it."""
    set_signal_at_parents_death = 1  # PR_SET_PDEATHSIG of prctl(2)
    ctypes.CDLL(None).prctl(set_signal_at_parents_death, signal.SIGTERM)


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Slurm:
    """Starts on construction; `stop` ends every process of it. `environment` is for those who talk to it."""

    def __init__(self):
        if os.geteuid() != 0:
            raise CannotStart("only root can start Slurm")
        missing = [
            name
            for name in ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol")
            if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")
        ]
        if missing:
            raise CannotStart(f"not installed: {', '.join(missing)} (script/bootstrap --cluster)")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ringfilm-slurm-"))
        self.folder.chmod(0o755)  # munged requires nobody else to write above its socket
        self.processes = []
        self.node = socket.gethostname().split(".")[0]
        self.environment = {
            **os.environ,
            "SLURM_CONF": str(self.folder / "slurm.conf"),
            "PATH": os.environ["PATH"] + ":/usr/sbin:/sbin",
        }
        for name in [name for name in self.environment if name.startswith(("SBATCH_", "SLURM_", "SQUEUE_"))]:
            if name != "SLURM_CONF":
                del self.environment[name]
        try:
            self._start()
        except BaseException:
            self.stop()
            raise

    def _start(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o600)
        (self.folder / "slurm.conf").write_text(
            CONFIGURATION.format(
                host=self.node,
                folder=self.folder,
                cpus=os.cpu_count(),
                controller_port=free_port(),
                node_port=free_port(),
            )
        )
        self._begin(
            "munged",
            "--foreground",
            f"--key-file={key}",
            f"--socket={self.folder}/munge.socket",
            f"--pid-file={self.folder}/munge.pid",
            f"--log-file={self.folder}/munge.log",
            f"--seed-file={self.folder}/munge.seed",
        )
        self._wait_for("munged", lambda: (self.folder / "munge.socket").exists())
        self._begin("slurmctld", "-D")
        self._begin("slurmd", "-D", "-N", self.node)
        self._wait_for("a node that is idle", lambda: "idle" in self.say("sinfo", "-h", "-o", "%T"))

    def _begin(self, *words):
        with open(self.folder / f"{words[0]}.out", "wb") as out:
            self.processes.append(
                subprocess.Popen(
                    words,
                    env=self.environment,
                    cwd=self.folder,
                    stdout=out,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                    preexec_fn=end_with_parent,
                )
            )

    def _wait_for(self, what, is_there, seconds=60):
        end = time.monotonic() + seconds
        while not is_there():
            dead = [process.args[0] for process in self.processes if process.poll() is not None]
            if dead or time.monotonic() > end:
                words = "".join(path.read_text(errors="replace")[-600:] for path in sorted(self.folder.glob("*.out")))
                raise CannotStart(f"{what} did not come up{'; ended: ' + ', '.join(dead) if dead else ''}: {words}")
            time.sleep(0.1)

    def say(self, *words):
        """What a command of Slurm prints."""
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60).stdout

    def order(self, *words):
        """As `state`; the command must succeed."""
        done = subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(words)}: {done.stdout}{done.stderr}")
        return done.stdout

    def in_queue(self):
        """(job with its task, state, reason) of all that are in the queue."""
        lines = self.say("squeue", "-h", "-r", "-o", "%i %T %r").splitlines()
        return [tuple(line.split(None, 2)) for line in lines]

    def wait_until_empty(self, seconds):
        end = time.monotonic() + seconds
        while self.in_queue():
            if time.monotonic() > end:
                raise AssertionError(f"still in the queue: {self.in_queue()}")
            time.sleep(0.3)

    def stop(self):
        if self.processes:
            if (self.folder / "munge.socket").exists():
                self.say("scancel", "--signal=KILL", "--full", "--state=RUNNING")
                self.say("scancel", "--state=PENDING,RUNNING,SUSPENDED")
                end = time.monotonic() + 20
                while self.in_queue() and time.monotonic() < end:
                    time.sleep(0.2)
        for process in reversed(self.processes):
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
                try:
                    process.wait(timeout=15)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
