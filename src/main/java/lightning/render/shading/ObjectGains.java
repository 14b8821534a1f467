package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.ShapeChange;
import lightning.scene.Stage;
import lightning.scene.light.Light;
import lightning.scene.value.ShapeGains;
import org.jspecify.annotations.Nullable;

/**
 * Gains of one light on the shapes of a scene: factors of its contributions, which composition applies. An edit of a gain therefore casts no
 * ray and changes no layer.
 *
 * @param entries for each shape the index of its gain
 * @param gains   gains; the first is 1, for shapes without a gain
 */
public record ObjectGains(short[] entries, float[] gains) {
    /** Returns the gains of a light; null if it has none. */
    public static @Nullable ObjectGains of(Light light, Stage stage) {
        ShapeGains gains = light.influence().gains();
        if (gains.isNone()) {
            return null;
        }
        float[] values = new float[gains.entries().size() + 1];
        values[0] = 1;
        for (int i = 1; i < values.length; i++) {
            values[i] = (float) light.limitedGain(gains.entries().get(i - 1).gain());
        }
        return new ObjectGains(stage.gainEntries(gains.names()), values);
    }

    /** Returns the gain on a shape. */
    public float of(int shape) {
        return gains[entries[shape]];
    }

    /**
     * Returns whether no shape that a change keeps has another gain.
     *
     * @param a gains before the change, or null for none
     * @param b gains after it, or null for none
     */
    public static boolean areSame(@Nullable ObjectGains a, @Nullable ObjectGains b, ShapeChange change) {
        if (a == b) {
            return true;
        }
        if (a == null || b == null) {
            return false;
        }
        return a.entries == b.entries && Arrays.equals(a.gains, b.gains)
                || change.allKept(a.entries.length, (before, after) -> a.of(before) == b.of(after));
    }

    /**
     * Writes tints times gains of rows.
     *
     * @param owners shape of each row
     * @param tint   one channel of the rows' tints; null if all are 1
     */
    public void write(int[] owners, int from, int to, float @Nullable [] tint, float[] out) {
        for (int i = from; i < to; i++) {
            float gain = gains[entries[owners[i]]];
            out[i] = tint == null ? gain : tint[i] * gain;
        }
    }
}
