"""A slow and lossy network between two hosts that are network namespaces of this machine. Needs root and /dev/net/tun.

A TUN device stands in each namespace; a thread carries packets between the two, late, and loses some or, for a while, all of them.
netem, which could do the same, is not in every kernel.
"""
import ctypes
import fcntl
import heapq
import os
import random
import select
import struct
import subprocess
import threading
import time

CLONE_NEWNET, TUNSETIFF, IFF_TUN_NO_PI = 0x40000000, 0x400454CA, 0x1001


def enter(namespace):
    """The calling thread is in it from now on."""
    with open(f"/run/netns/{namespace}") as file:
        if ctypes.CDLL(None, use_errno=True).setns(file.fileno(), CLONE_NEWNET) != 0:
            raise OSError(ctypes.get_errno(), f"cannot enter the namespace {namespace}")


def tun(namespace, address, peer):
    """A TUN device in a namespace, as a file descriptor."""
    made = {}

    def make():
        enter(namespace)
        made["fd"] = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
        fcntl.ioctl(made["fd"], TUNSETIFF, struct.pack("16sH", b"relay", IFF_TUN_NO_PI))

    thread = threading.Thread(target=make)
    thread.start()
    thread.join()
    in_it = ["ip", "-n", namespace]
    subprocess.run([*in_it, "addr", "add", address, "peer", peer, "dev", "relay"], check=True)
    subprocess.run([*in_it, "link", "set", "dev", "relay", "up"], check=True)
    subprocess.run([*in_it, "link", "set", "dev", "lo", "up"], check=True)
    return made["fd"]


class SlowLink:
    """`hosts`: name of a namespace → address. As a context it makes the namespaces and removes them."""

    def __init__(self, hosts, delay=0.05, jitter=0.02, loss=0.005, seed=1):
        self.hosts, self.delay, self.jitter, self.loss = hosts, delay, jitter, loss
        self.random = random.Random(seed)
        self.down = False
        self.carried = self.lost = 0
        self.ended = threading.Event()

    def __enter__(self):
        for name in self.hosts:
            subprocess.run(["ip", "netns", "del", name], check=False, stderr=subprocess.DEVNULL)  # Of a run that was killed.
            subprocess.run(["ip", "netns", "add", name], check=True)
        (one, first), (two, second) = self.hosts.items()
        self.ends = [tun(one, first, second), tun(two, second, first)]
        self.thread = threading.Thread(target=self.carry, daemon=True)
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.ended.set()
        self.thread.join()
        for end in self.ends:
            os.close(end)
        for name in self.hosts:
            subprocess.run(["ip", "netns", "del", name], check=False)

    def carry(self):
        on_the_way, number = [], 0
        while not self.ended.is_set():
            wait = min(0.2, max(0.0, on_the_way[0][0] - time.monotonic())) if on_the_way else 0.2
            for end in select.select(self.ends, [], [], wait)[0]:
                packet = os.read(end, 65536)
                if self.down or self.random.random() < self.loss:
                    self.lost += 1
                    continue
                due = time.monotonic() + self.delay + self.random.uniform(0.0, self.jitter)
                number += 1
                heapq.heappush(on_the_way, (due, number, self.ends[1 - self.ends.index(end)], packet))
            while on_the_way and on_the_way[0][0] <= time.monotonic():
                _, _, end, packet = heapq.heappop(on_the_way)
                self.carried += 1
                try:
                    os.write(end, packet)
                except OSError:
                    self.lost += 1  # Its queue is full, as a router's may be.
