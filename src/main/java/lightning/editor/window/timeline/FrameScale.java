package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/**
 * Linear scale from frames to horizontal positions in a row.
 *
 * @param from frame at the left edge; may be fractional
 * @param to frame at the right edge, greater than {@code from}
 * @param width pixels
 */
record FrameScale(double from, double to, double width) {
    /** Margin left and right of the outermost frames, pixels: half a keyframe mark plus a gap. */
    private static final double MARGIN = 12;
    private static final double MIN_SPAN = 4;
    /** Minimum distance between two frame numbers, pixels. */
    private static final double LABEL_SPACING = 52;

    /** Returns the scale that shows all frames and all keyframes of a shot. */
    static FrameScale of(Shot shot, double width) {
        int first = shot.first();
        int last = shot.last();
        for (Track track : shot.tracks()) {
            List<Keyframe> keys = track.keys();
            first = Math.min(first, keys.getFirst().frame());
            last = Math.max(last, keys.getLast().frame());
        }
        return new FrameScale(first, Math.max(last, first + MIN_SPAN), width);
    }

    private double pixelsPerFrame() {
        return Math.max(1, width - 2 * MARGIN) / (to - from);
    }

    double x(double frame) {
        return MARGIN + (frame - from) * pixelsPerFrame();
    }

    int frame(double x) {
        return (int) Math.clamp(Math.rint(from + (x - MARGIN) / pixelsPerFrame()), 0, Shot.MAX_FRAME);
    }

    boolean isVisible(double frame) {
        double x = x(frame);
        return x >= 0 && x <= width;
    }

    /** Zooms about a position. Never shows more than the full scale. */
    FrameScale zoom(double factor, double x, FrameScale fullScale) {
        double center = from + (x - MARGIN) / pixelsPerFrame();
        double span = Math.clamp((to - from) / factor, Math.min(MIN_SPAN, fullScale.to - fullScale.from), fullScale.to - fullScale.from);
        double start = center - (center - from) * span / (to - from);
        return new FrameScale(start, start + span, width).clampTo(fullScale);
    }

    /** Moves the visible range within the full scale. */
    FrameScale pan(double pixels, FrameScale fullScale) {
        double frames = pixels / pixelsPerFrame();
        return new FrameScale(from + frames, to + frames, width).clampTo(fullScale);
    }

    FrameScale clampTo(FrameScale fullScale) {
        double span = Math.min(to - from, fullScale.to - fullScale.from);
        double start = Math.clamp(from, fullScale.from, fullScale.to - span);
        return new FrameScale(start, start + span, fullScale.width);
    }

    /** Returns the frames that have a number. Their spacing is 1, 2 or 5 times a power of ten. */
    List<Integer> labeledFrames() {
        double minStep = LABEL_SPACING / pixelsPerFrame();
        long step = 1;
        for (int i = 0; step < minStep; i++) {
            step = i % 3 == 1 ? step / 2 * 5 : step * 2;
        }
        List<Integer> frames = new ArrayList<>();
        for (long frame = Math.max(0, (long) Math.ceil(from / step) * step); frame <= to && frame <= Shot.MAX_FRAME; frame += step) {
            frames.add((int) frame);
        }
        return frames;
    }
}
