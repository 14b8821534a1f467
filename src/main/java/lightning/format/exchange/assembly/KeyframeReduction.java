package lightning.format.exchange.assembly;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;

/**
 * Drops keys that interpolation between the others gives.
 *
 * @param unit smallest size of values that the tolerance is a share of
 */
public record KeyframeReduction(double unit) {
    /** Tolerance as a share of the values: files have single precision, of about seven digits. */
    public static final double TOLERANCE = 1e-6;

    /**
     * Returns the keys that are needed.
     *
     * @param isLinear false for directions: between two of them, Lightning rotates
     */
    public List<Keyframe> reduce(List<Keyframe> keys, boolean isLinear) {
        List<Keyframe> kept = new ArrayList<>();
        int start = 0;
        for (int i = 0; i < keys.size(); i++) {
            boolean isEnd = i == 0 || i == keys.size() - 1;
            if (isEnd || !isRedundant(keys.subList(start, i + 2), isLinear)) {
                kept.add(keys.get(i));
                start = i;
            }
        }
        while (kept.size() > 1 && kept.getLast().value().equals(kept.get(kept.size() - 2).value())) {
            kept.removeLast();
        }
        return kept;
    }

    /** Returns whether all keys between the first and the last equal their interpolation. */
    private boolean isRedundant(List<Keyframe> keys, boolean isLinear) {
        Keyframe first = keys.getFirst();
        Keyframe last = keys.getLast();
        List<Keyframe> between = keys.subList(1, keys.size() - 1);
        if (first.interpolation() == Interpolation.LINEAR && isLinear) {
            return between.stream().allMatch(key -> isOnLine(first, key, last));
        }
        // A stepped value holds until its next key; a direction that changes afterwards must hold until then.
        return between.stream().allMatch(key -> key.value().equals(first.value()))
                && (first.interpolation() == Interpolation.STEPPED || last.value().equals(first.value()));
    }

    private boolean isOnLine(Keyframe first, Keyframe key, Keyframe last) {
        double t = (double) (key.frame() - first.frame()) / (last.frame() - first.frame());
        List<Double> from = numbers(first);
        List<Double> to = numbers(last);
        List<Double> values = numbers(key);
        for (int i = 0; i < values.size(); i++) {
            double scale = Math.max(unit, Math.max(Math.abs(from.get(i)), Math.abs(to.get(i))));
            if (!(Math.abs(from.get(i) + t * (to.get(i) - from.get(i)) - values.get(i)) <= TOLERANCE * scale)) {
                return false;
            }
        }
        return true;
    }

    private static List<Double> numbers(Keyframe key) {
        return ((KeyframeValue.Numbers) key.value()).values();
    }
}
