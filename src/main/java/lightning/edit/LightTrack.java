package lightning.edit;

import lightning.scene.Light;

/**
 * The history of one light alone, in chains that several states of the document share.
 *
 * @param past   what it was, the latest first; null where there is nothing
 * @param future what was undone, the next to redo first; null where there is nothing
 */
record LightTrack(Link past, Link future) {
    static final LightTrack EMPTY = new LightTrack(null, null);

    record Link(Light light, Link rest) {}

    LightTrack edited(Light old) {
        return new LightTrack(new Link(old, past), null);
    }

    LightTrack undone(Light now) {
        return new LightTrack(past.rest(), new Link(now, future));
    }

    LightTrack redone(Light now) {
        return new LightTrack(new Link(now, past), future.rest());
    }
}
