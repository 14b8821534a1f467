package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Choice;
import lightning.scene.Keying;
import lightning.scene.Light;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.ValueKind;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Shots of a scene: keys of any attribute that the tables call keyable, at any frames. Nothing here names one. */
public final class ShotArbitraries {
    /** Frames up to here, so that what lies between keys is often asked for. */
    public static final int LAST = 40;

    private ShotArbitraries() {}

    public static Arbitrary<Shot> shots(Scene scene) {
        List<Arbitrary<Track>> all = targets(scene).stream().flatMap(t -> t.attributes(scene).stream()
                .filter(a -> a.kind().keying() != Keying.NONE).map(a -> tracks(t, a))).toList();
        Arbitrary<Shot> shot = Arbitraries.of(all).flatMap(t -> t).list().ofMaxSize(6).map(tracks -> {
            List<Track> once = new ArrayList<>();
            tracks.stream().filter(t -> once.stream().noneMatch(o -> o.target().equals(t.target()) && o.attribute().equals(t.attribute())))
                    .forEach(once::add);
            return new Shot(0, LAST, 24, once);
        });
        return Combinators.combine(shot, Arbitraries.integers().between(0, LAST), Numbers.between(Shot.MIN_RATE, Shot.MAX_RATE))
                .as((s, first, rate) -> new Shot(first, LAST, rate, s.tracks()));
    }

    private static List<Target> targets(Scene scene) {
        Stream<Target> nodes = scene.nodes().stream().map(n -> Target.node(n.name()));
        return Stream.of(Stream.of(Target.CAMERA), scene.lights().stream().map(Light::name).map(Target::light),
                scene.rig().banks().stream().map(Bank::name).map(Target::bank), nodes).flatMap(s -> s).toList();
    }

    private static Arbitrary<Track> tracks(Target target, Attribute<?, ?> attribute) {
        return Arbitraries.integers().between(0, LAST).list().ofMinSize(1).ofMaxSize(5).map(TreeSet::new)
                .flatMap(frames -> Combinators.combine(settings(attribute.kind()).list().ofSize(frames.size()),
                        passages(attribute.kind()).list().ofSize(frames.size())).as((settings, passages) -> {
                            List<Key> keys = new ArrayList<>();
                            for (int frame : frames) {
                                keys.add(new Key(frame, settings.get(keys.size()), passages.get(keys.size())));
                            }
                            return new Track(target, attribute.name(), keys);
                        }));
    }

    private static Arbitrary<Passage> passages(ValueKind<?> kind) {
        return kind.keying() == Keying.HOLDS ? Arbitraries.just(Passage.STEPPED) : Arbitraries.of(Passage.values());
    }

    private static <V> Arbitrary<Setting> settings(ValueKind<V> kind) {
        return switch (kind) {
            case Quantity<V> q -> AttributeArbitraries.numbers(q).filter(v -> isAllowed(q, v))
                    .map(v -> new Setting.Numbers(q.split().apply(v)));
            case Choice<V> c -> Arbitraries.of(c.words()).map(Setting.Word::new);
            case ValueKind.Filed<?> _,ValueKind.Linking _,ValueKind.Naming _,ValueKind.Texturing _ ->
                    throw new IllegalArgumentException("no keys");
        };
    }

    private static <V> boolean isAllowed(Quantity<V> q, V value) {
        try {
            q.check("value", value);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }
}
