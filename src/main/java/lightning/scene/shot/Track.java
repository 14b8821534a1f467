package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Attribute;
import lightning.scene.Choice;
import lightning.scene.Keying;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.ValueKind;

/**
 * The keys of one attribute of something.
 *
 * @param attribute its name as a file writes it
 * @param keys      one at least, in the order of their frames, one for a frame
 */
public record Track(Target target, String attribute, List<Key> keys) {
    public Track {
        keys = List.copyOf(keys);
        if (keys.isEmpty()) {
            throw new IllegalArgumentException(target + ": " + attribute + " must have a key");
        }
        for (int i = 1; i < keys.size(); i++) {
            if (keys.get(i).frame() <= keys.get(i - 1).frame()) {
                throw new IllegalArgumentException(target + ": " + attribute + ": keys must be in the order of their frames, found "
                        + keys.get(i).frame() + " behind " + keys.get(i - 1).frame());
            }
        }
    }

    /** These keys of something else. */
    public Track of(Target other) {
        return new Track(other, attribute, keys);
    }

    /** These keys some frames later, or earlier where the number is negative. */
    public Track later(int frames) {
        return new Track(target, attribute,
                keys.stream().map(k -> new Key(Math.addExact(k.frame(), frames), k.setting(), k.passage())).toList());
    }

    /** The key at a frame. */
    public Optional<Key> key(int frame) {
        return keys.stream().filter(k -> k.frame() == frame).findFirst();
    }

    /** These keys and another, in place of the one at its frame. */
    public Track with(Key key) {
        List<Key> all = new ArrayList<>(keys);
        int place = 0;
        while (place < all.size() && all.get(place).frame() < key.frame()) {
            place++;
        }
        if (place < all.size() && all.get(place).frame() == key.frame()) {
            all.set(place, key);
        } else {
            all.add(place, key);
        }
        return new Track(target, attribute, all);
    }

    /** With another value at a frame: the key there goes on as it did, a new one as the key before it, or as the first. */
    public Track with(int frame, Setting setting) {
        Key before = keys.getFirst();
        for (Key key : keys) {
            before = key.frame() <= frame ? key : before;
        }
        return with(new Key(frame, setting, before.passage()));
    }

    /**
     * Refuses keys that the scene cannot have.
     *
     * @throws IllegalArgumentException if what has them is not there, or lacks the attribute, or if the attribute has no keys at all or
     *                                  may not have one's value
     */
    public void check(Scene scene) {
        check(target.attribute(scene, attribute).<Attribute<?, ?>>map(a -> a)
                .orElseThrow(() -> new IllegalArgumentException(target + " has no " + attribute + " with keys")));
    }

    /**
     * Refuses keys that the attribute cannot have.
     *
     * @throws IllegalArgumentException if it has none at all, if a value is none of its own, or if words or whole numbers are to
     *                                  go from key to key
     */
    private void check(Attribute<?, ?> known) {
        if (known.kind().keying() == Keying.NONE) {
            throw new IllegalArgumentException(target + ": " + attribute + " has no keys: only numbers and words have");
        }
        for (Key key : keys) {
            if (known.kind().keying() == Keying.HOLDS && key.passage() != Passage.STEPPED) {
                throw new IllegalArgumentException(target + ": " + attribute + " stays until its next key, so it must be stepped");
            }
            check(known.kind(), key.setting());
        }
    }

    private <V> void check(ValueKind<V> kind, Setting setting) {
        boolean right = switch (kind) {
            case Quantity<V> n -> setting instanceof Setting.Numbers(List<Double> all) && all.size() == n.labels().size();
            case Choice<V> c -> setting instanceof Setting.Word(String text) && c.words().contains(text);
            case ValueKind.Filed<?> _,ValueKind.Linking _,ValueKind.Naming _,ValueKind.Texturing _ -> false;
        };
        if (!right) {
            throw new IllegalArgumentException(target + ": " + attribute + " cannot be " + setting);
        }
        if (kind instanceof Quantity<V> n && setting instanceof Setting.Numbers(List<Double> all)) {
            all.forEach(number -> n.check(attribute, number.doubleValue()));
        }
        kind.check(attribute, value(kind, setting));
    }

    /**
     * The value at a frame: at a key the key's in every bit, before the first key and behind the last one theirs.
     *
     * @param frame may lie between two frames
     * @param kind  the attribute's
     */
    <V> V at(double frame, ValueKind<V> kind) {
        int last = 0;
        int behind = keys.size();
        while (behind - last > 1) {
            int middle = (last + behind) >>> 1;
            if (keys.get(middle).frame() <= frame) {
                last = middle;
            } else {
                behind = middle;
            }
        }
        Key from = keys.get(last);
        if (frame <= from.frame() || last == keys.size() - 1 || from.passage() == Passage.STEPPED) {
            return value(kind, from.setting());
        }
        Quantity<V> quantity = (Quantity<V>) kind;
        List<Double> numbers = from.passage() == Passage.SMOOTH ? smooth(last, frame)
                : Between.linear(quantity.form(), numbers(last), numbers(last + 1), share(last, frame));
        return quantity.join().apply(numbers);
    }

    private double share(int last, double frame) {
        int start = keys.get(last).frame();
        return (frame - start) / (keys.get(last + 1).frame() - start);
    }

    private List<Double> smooth(int last, double frame) {
        List<Double> all = new ArrayList<>();
        for (int i = 0; i < numbers(last).size(); i++) {
            double slope = slope(last, i);
            double next = slope(last + 1, i);
            all.add(Between.smooth(numbers(last).get(i), numbers(last + 1).get(i), slope, next,
                    keys.get(last + 1).frame() - keys.get(last).frame(), share(last, frame)));
        }
        return all;
    }

    /** The slope at a key, of one number: 0 at both ends. */
    private double slope(int key, int number) {
        if (key == 0 || key == keys.size() - 1) {
            return 0;
        }
        return Between.slope(numbers(key - 1).get(number), numbers(key).get(number), numbers(key + 1).get(number),
                keys.get(key).frame() - keys.get(key - 1).frame(), keys.get(key + 1).frame() - keys.get(key).frame());
    }

    private List<Double> numbers(int key) {
        return ((Setting.Numbers) keys.get(key).setting()).all();
    }

    private static <V> V value(ValueKind<V> kind, Setting setting) {
        return switch (setting) {
            case Setting.Numbers(List<Double> all) -> ((Quantity<V>) kind).join().apply(all);
            case Setting.Word(String text) -> ((Choice<V>) kind).value(text);
        };
    }
}
