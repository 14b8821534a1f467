package lightning.editor.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.LightAttribute;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** A recorded way of a light as keys of a shot, and back: at every frame the light is the same in every bit. */
public final class PathKeys {
    private PathKeys() {}

    /**
     * A shot in which a light also goes a way; keys that it had of its position and direction are replaced.
     *
     * @param first the frame of the way's begin
     * @throws IllegalArgumentException if a key would lie behind {@link Shot#MAX_FRAME}, or if there were too many
     */
    public static Shot of(Shot shot, String light, MotionPath path, int first) {
        List<Key> positions = new ArrayList<>();
        List<Key> directions = new ArrayList<>();
        for (int i = 0; i < path.keys().size(); i++) {
            int frame = Math.addExact(first, i * path.every());
            positions.add(key(frame, path.keys().get(i).position()));
            directions.add(key(frame, path.keys().get(i).direction()));
        }
        Target target = Target.light(light);
        return shot.with(new Track(target, LightAttribute.POSITION.name(), positions))
                .with(new Track(target, LightAttribute.DIRECTION.name(), directions));
    }

    private static Key key(int frame, Vec3 v) {
        return new Key(frame, new Setting.Numbers(List.of(v.x(), v.y(), v.z())), Passage.LINEAR);
    }

    /**
     * The way that a light goes in a shot; it begins at the first key. Nothing where the light's position and direction have no keys
     * at the same frames, evenly spaced, from each of which they go on evenly.
     */
    public static Optional<MotionPath> path(Shot shot, String light) {
        List<Key> positions = keys(shot, light, LightAttribute.POSITION);
        List<Key> directions = keys(shot, light, LightAttribute.DIRECTION);
        int size = positions.size();
        if (size == 0 || size != directions.size() || size > MotionPath.MAX_KEYS) {
            return Optional.empty();
        }
        int first = positions.getFirst().frame();
        int every = size == 1 ? MotionPath.DEFAULT_EVERY : positions.get(1).frame() - first;
        if (every > MotionPath.MAX_EVERY) {
            return Optional.empty();
        }
        List<MotionPath.Key> keys = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            if (!isOnTheWay(positions.get(i), first + (long) i * every) || !isOnTheWay(directions.get(i), first + (long) i * every)) {
                return Optional.empty();
            }
            keys.add(new MotionPath.Key(vector(positions.get(i)), vector(directions.get(i))));
        }
        return Optional.of(new MotionPath(every, keys));
    }

    private static List<Key> keys(Shot shot, String light, LightAttribute<Vec3> attribute) {
        return shot.track(Target.light(light), attribute.name()).map(Track::keys).orElse(List.of());
    }

    private static boolean isOnTheWay(Key key, long frame) {
        return key.frame() == frame && key.passage() == Passage.LINEAR;
    }

    private static Vec3 vector(Key key) {
        List<Double> n = ((Setting.Numbers) key.setting()).all();
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }
}
