package lightning.editor.document.motion;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.shot.Between;

/**
 * The way of a light across the frames of the preview (paper §3.7): where it was and where it shone to, every so many
 * frames.
 *
 * @param every how many frames lie from one key to the next, ≥ 1
 * @param keys  at least one
 */
public record MotionPath(int every, List<Key> keys) {
    public static final int DEFAULT_EVERY = 10;
    public static final int MAX_EVERY = 10_000;
    public static final int MAX_KEYS = 100_000;

    public MotionPath {
        keys = List.copyOf(keys);
        Limits.range("every", every, 1, MAX_EVERY);
        Limits.range("the number of keys", keys.size(), 1, MAX_KEYS);
    }

    /** The light's transform at one frame; within the limits of a scene. */
    public record Key(Vec3 position, Vec3 direction) {
        public Key {
            Light.of("light", LightType.SPOT).withPosition(position).withDirection(direction);
        }

        static Key of(Light light) {
            return new Key(light.position(), light.direction());
        }

        Light on(Light light) {
            return light.withPosition(position).withDirection(direction);
        }
    }

    /** How many frames the path takes: the first key is frame 0, the last key the last frame. */
    public int frames() {
        return (keys.size() - 1) * every + 1;
    }

    /**
     * The light on its way. Between keys it moves in a straight line, and its direction turns on the shorter arc; at a
     * key it is the key's in every bit. Before the path and behind it, it stands at its ends.
     *
     * @param frame from 0; may lie between two frames
     */
    public Light at(Light light, double frame) {
        double passed = Math.clamp(frame, 0, frames() - 1);
        int last = Math.min((int) (passed / every), keys.size() - 1);
        double share = (passed - last * every) / every;
        Key from = keys.get(last);
        if (share <= 0) {
            return from.on(light);
        }
        Key to = keys.get(last + 1);
        Vec3 position = Between.position(from.position(), to.position(), share);
        Vec3 direction = Between.direction(from.direction(), to.direction(), share);
        return new Key(position, direction).on(light);
    }
}
