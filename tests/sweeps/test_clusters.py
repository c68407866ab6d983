"""Sweeps by a Dask cluster: the same bytes, whatever becomes of it, and sentences where it cannot be used."""

from __future__ import annotations

import importlib
import json
import os
import re
import socket
import subprocess
import sys
from pathlib import Path
from socketserver import BaseRequestHandler, ThreadingTCPServer
from threading import Thread

import pytest
from cli import refusal
from clusters import Cluster
from places import ROOT
from programs import PATIENCE, Programs, wait_until
from small_parts import DEADLY, KILLS, Running, SmallParts, plan_of, run

import kurbel

SWEEP = SmallParts(plan_of(DEADLY + 4))


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    target = tmp_path_factory.mktemp("whole") / "delta.parquet"
    run(SWEEP, str(target), Running(jobs=1))
    return target.read_bytes()


@pytest.fixture
def cluster(programs: Programs, tmp_path: Path) -> Cluster:
    return Cluster(programs, tmp_path)


@pytest.mark.slow
def test_workers_write_the_bytes_of_one_machine_and_one_that_dies_changes_none(
    cluster: Cluster, tmp_path: Path, whole: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    cluster.work()
    cluster.work()
    target = str(tmp_path / "delta.parquet")
    place = importlib.import_module("kurbel.sweeps.parts").Place
    with monkeypatch.context() as patch:
        # Elsewhere they see no folder, and what they make comes over the network.
        patch.setattr(
            "kurbel.sweeps.folder.Place",
            lambda *names: place(names[0], str(tmp_path / "elsewhere"), names[2]),
        )
        run(SWEEP, target, Running(scheduler=cluster.address))
    assert Path(target).read_bytes() == whole
    # Here they write it.
    monkeypatch.delattr("kurbel.sweeps.run.kept")
    (tmp_path / KILLS).touch()
    run(SWEEP, target, Running(scheduler=cluster.file))
    assert Path(target).read_bytes() == whole
    wait_until(lambda: sum(worker.poll() is not None for worker in cluster.workers) == 1)
    assert not Path(f"{target}.parts").exists()


@pytest.mark.slow
def test_a_scheduler_that_goes_away_leaves_parts_that_one_goes_on_with(
    cluster: Cluster, tmp_path: Path, whole: bytes
) -> None:
    target, seen = str(tmp_path / "delta.parquet"), []

    def watch(rows: int) -> None:
        seen.append(rows)
        if len(seen) == 3:
            cluster.scheduler.kill()

    cluster.work()
    with pytest.raises(kurbel.KurbelError) as raised:
        run(SWEEP, target, Running(scheduler=cluster.address, watch=watch))
    assert str(raised.value) == (
        f"the scheduler at {cluster.address} is gone, or it dropped the work; finished parts are kept in"
        f" {target}.parts: the same command with --resume goes on"
    )
    run(SWEEP, target, Running(jobs=1, resume=True))
    assert Path(target).read_bytes() == whole


@pytest.mark.slow
def test_workers_that_might_write_other_bytes_are_refused(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = str(tmp_path / "delta.parquet")
    monkeypatch.setattr("kurbel.sweeps.cluster.WORKERS", 1)
    with pytest.raises(
        kurbel.KurbelError, match=r"has no workers, and none came in 1 s; start some by: dask worker tcp"
    ):
        run(SWEEP, target, Running(scheduler=cluster.address))
    monkeypatch.undo()
    noted = tmp_path / "other" / "numpy-1.0.dist-info" / "METADATA"
    noted.parent.mkdir(parents=True)
    noted.write_text("Metadata-Version: 2.1\nName: numpy\nVersion: 1.0\n")
    cluster.work(str(tmp_path / "other"))
    with pytest.raises(
        kurbel.KurbelError, match=r"^worker tcp://127\.\S+ has numpy 1\.0 in place of [2-9]\S+; its bytes"
    ):
        run(SWEEP, target, Running(scheduler=cluster.address))
    assert os.listdir(tmp_path).count("delta.parquet.parts") == 0


def test_a_scheduler_that_is_not_there_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("kurbel.sweeps.cluster.PATIENCE", 1)
    with socket.socket() as taken:
        # Nobody listens there.
        taken.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{taken.getsockname()[1]}"
        said = refusal("sweep", "delta", "--eps=2..4", "-o", "d.csv", "--scheduler", address, code=1)
    assert said == f"no scheduler answered at {address} within 1 s; start one by: dask scheduler"
    said = refusal("sweep", "delta", "--eps=2..4", "-o", "d.csv", "--scheduler", "none.json", code=1)
    assert said.startswith("there is no address of a scheduler in none.json, and none came in 1 s; start one")
    said = refusal("sweep", "delta", "--eps=2..4", "-o", "d.csv", "--scheduler", "tls://127.0.0.1:1", code=1)
    assert said.startswith("tls://127.0.0.1:1 needs certificates; name them in the configuration of Dask")
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize(
    ("greeting", "patience", "sentence"),
    [
        # One that speaks HTTP waits for a request, or refuses ours.
        (b"", 1, "what answers at {} has not greeted as a scheduler within 1 s;"),
        (
            b"HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n",
            PATIENCE,
            "what answers at {} is no scheduler;",
        ),
    ],
)
def test_what_is_no_scheduler_is_one_sentence(
    greeting: bytes, patience: float, sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Server(BaseRequestHandler):
        def handle(self) -> None:
            self.request.sendall(greeting)
            while self.request.recv(1024):
                pass

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("kurbel.sweeps.cluster.PATIENCE", patience)
    with ThreadingTCPServer(("127.0.0.1", 0), Server) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        address = f"tcp://127.0.0.1:{server.server_address[1]}"
        said = refusal("sweep", "delta", "--eps=2..4", "-o", "d.csv", "--scheduler", address, code=1)
        server.shutdown()
    port = "name the port that dask scheduler prints, 8786 if it is given no other"
    assert said == f"{sentence.format(address)} {port}"
    assert not [*tmp_path.iterdir()]


@pytest.mark.slow
def test_a_worker_without_kurbel_is_one_sentence(cluster: Cluster, tmp_path: Path) -> None:
    (tmp_path / "lacks" / "kurbel").mkdir(parents=True)
    (tmp_path / "lacks" / "kurbel" / "__init__.py").write_text(
        "raise ModuleNotFoundError(\"No module named 'kurbel'\", name='kurbel')"
    )
    cluster.work(str(tmp_path / "lacks"))
    words = ("sweep", "delta", "--eps=2..4", "-o", str(tmp_path / "d.csv"), "--scheduler", cluster.address)
    assert re.fullmatch(
        r"worker tcp://\S+ cannot run kurbel: ModuleNotFoundError\(.*'kurbel'.*\); install .* here",
        refusal(*words, code=1),
    )
    assert not (tmp_path / "d.csv.parts").exists()


@pytest.mark.slow
def test_a_scheduler_that_goes_away_as_its_workers_are_asked_is_one_sentence(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from distributed import Client

    def waited(*about: object, **more: object) -> None:
        cluster.scheduler.kill()
        cluster.scheduler.wait()

    monkeypatch.setattr(Client, "wait_for_workers", waited)
    words = ("sweep", "delta", "--eps=2..4", "-o", str(tmp_path / "d.csv"), "--scheduler", cluster.address)
    assert refusal(*words, code=1) == (f"the scheduler at {cluster.address} is gone, or it dropped the work")


def behind(name: str, code: str) -> str:
    """Run a line behind a script of the page, in a process of its own, and return what it prints."""
    page = (ROOT / "docs" / "scale.md").read_text(encoding="utf-8")
    (script,) = re.findall(rf"^```python file={name}\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    lines = f"__name__ = 'of the page'\n{script}\n{code}"
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_the_scripts_for_slurm_and_kubernetes_ask_for_what_they_say() -> None:
    here = 'interface="lo", scheduler_options={"host": "127.0.0.1", "dashboard": False}'
    job = behind("slurm.py", f"with slurm({here}) as cluster: print(cluster.job_script())")
    lines = job.splitlines()
    assert {"#SBATCH -p batch", "#SBATCH --cpus-per-task=16", "#SBATCH -t 04:00:00"} <= {*lines}
    assert "--nthreads 1 --memory-limit 1.86GiB --nworkers 16" in lines[-2 if not lines[-1] else -1]
    asked = json.loads(behind("kubernetes.py", "import json; print(json.dumps(spec()))"))
    assert (asked["apiVersion"], asked["kind"]) == ("kubernetes.dask.org/v1", "DaskCluster")
    worker = asked["spec"]["worker"]
    container = worker["spec"]["containers"][0]
    assert (worker["replicas"], container["args"][-2:]) == (32, ["--nthreads", "1"])
    assert container["volumeMounts"][0]["name"] == worker["spec"]["volumes"][0]["name"]
