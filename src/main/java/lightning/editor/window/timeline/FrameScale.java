package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.shot.Key;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/**
 * Where frames stand in a row.
 *
 * @param from  the frame at the left, which may lie between two
 * @param to    the frame at the right, beyond {@code from}
 * @param width pixels
 */
record FrameScale(double from, double to, double width) {
    /** Left and right of the outermost frames, pixels: half a key and a little. */
    private static final double MARGIN = 12;
    private static final double LEAST_SPAN = 4;
    /** From number to number, pixels. */
    private static final double APART = 52;

    /** All frames of a shot, and all of its keys. */
    static FrameScale of(Shot shot, double width) {
        int first = shot.first();
        int last = shot.last();
        for (Track track : shot.tracks()) {
            List<Key> keys = track.keys();
            first = Math.min(first, keys.getFirst().frame());
            last = Math.max(last, keys.getLast().frame());
        }
        return new FrameScale(first, Math.max(last, first + LEAST_SPAN), width);
    }

    private double perFrame() {
        return Math.max(1, width - 2 * MARGIN) / (to - from);
    }

    double x(double frame) {
        return MARGIN + (frame - from) * perFrame();
    }

    int frame(double x) {
        return (int) Math.clamp(Math.rint(from + (x - MARGIN) / perFrame()), 0, Shot.MAX_FRAME);
    }

    boolean shows(double frame) {
        double x = x(frame);
        return x >= 0 && x <= width;
    }

    /** Nearer or farther about a place, and never beyond the whole. */
    FrameScale zoomed(double factor, double x, FrameScale whole) {
        double about = from + (x - MARGIN) / perFrame();
        double span = Math.clamp((to - from) / factor, Math.min(LEAST_SPAN, whole.to - whole.from), whole.to - whole.from);
        double start = about - (about - from) * span / (to - from);
        return new FrameScale(start, start + span, width).within(whole);
    }

    /** Moved along. */
    FrameScale moved(double pixels, FrameScale whole) {
        double frames = pixels / perFrame();
        return new FrameScale(from + frames, to + frames, width).within(whole);
    }

    FrameScale within(FrameScale whole) {
        double span = Math.min(to - from, whole.to - whole.from);
        double start = Math.clamp(from, whole.from, whole.to - span);
        return new FrameScale(start, start + span, whole.width);
    }

    /** The frames that have a number, 1, 2 or 5 times a power of ten apart. */
    List<Integer> numbers() {
        double least = APART / perFrame();
        long step = 1;
        for (int i = 0; step < least; i++) {
            step = i % 3 == 1 ? step / 2 * 5 : step * 2;
        }
        List<Integer> all = new ArrayList<>();
        for (long frame = Math.max(0, (long) Math.ceil(from / step) * step); frame <= to && frame <= Shot.MAX_FRAME; frame += step) {
            all.add((int) frame);
        }
        return all;
    }
}
