// The way to the server: commands go out with a number, answers come back by it, everything else is an event.

import { readFrame } from "./frames.js";

const AGAIN = 1000; // ms until a lost connection is tried again

export class Connection {
  /** `hear(event)` and `draw(frame)` are told what comes; `change(open)` whether there is a connection. */
  constructor(hear, draw, change) {
    Object.assign(this, { hear, draw, change, waiting: new Map(), last: 0 });
    this.open();
  }

  open() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    this.socket = new WebSocket(`${scheme}://${location.host}/socket`);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => this.change(true);
    this.socket.onmessage = ({ data }) =>
      typeof data === "string" ? this.take(JSON.parse(data)) : this.draw(readFrame(data));
    this.socket.onclose = () => {
      this.change(false);
      for (const { refuse } of this.waiting.values()) refuse({ text: "the connection was lost" });
      this.waiting.clear();
      setTimeout(() => this.open(), AGAIN);
    };
  }

  take(event) {
    if (event.event !== "answer") return this.hear(event);
    const waiting = this.waiting.get(event.id);
    this.waiting.delete(event.id);
    if (!waiting) return undefined;
    return event.failed ? waiting.refuse(event.failed) : waiting.resolve(event);
  }

  /** Sends a command; the promise holds the result, or is refused with what is wrong. */
  ask(what, values = {}) {
    return new Promise((resolve, refuse) => {
      if (this.socket.readyState !== WebSocket.OPEN) {
        refuse({ text: "there is no connection to the workbench; is pam-cosim still running?" });
        return;
      }
      const id = ++this.last;
      this.waiting.set(id, { resolve, refuse });
      this.socket.send(JSON.stringify({ id, do: what, ...values }));
    });
  }
}

/** Sends the newest of many values, one at a time: what is dragged never queues. */
export class Newest {
  constructor(send) {
    Object.assign(this, { send, next: null, busy: false });
  }

  async give(values) {
    this.next = { ...this.next, ...values };
    if (this.busy) return;
    this.busy = true;
    try {
      while (this.next) {
        const values = this.next;
        this.next = null;
        await this.send(values);
      }
    } finally {
      this.busy = false;
    }
  }
}
