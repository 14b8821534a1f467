package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Arbitrary shots of a scene: keyframes of all animatable attributes, at any frames. */
public final class ShotArbitraries {
    /** Last frame, small so that frames between keyframes are often evaluated. */
    public static final int LAST = 40;

    private ShotArbitraries() {}

    public static Arbitrary<Shot> shots(Scene scene) {
        List<Arbitrary<Track>> all = targets(scene).stream().flatMap(t -> t.attributes(scene).stream()
                .filter(a -> a.kind().keyframeSupport() != KeyframeSupport.NONE).map(a -> tracks(t, a))).toList();
        Arbitrary<Shot> shot = Arbitraries.of(all).flatMap(t -> t).list().ofMaxSize(6).map(tracks -> {
            List<Track> once = new ArrayList<>();
            tracks.stream().filter(t -> once.stream().noneMatch(o -> o.target().equals(t.target()) && o.attribute().equals(t.attribute())))
                    .forEach(once::add);
            return new Shot(0, LAST, 24, once);
        });
        return Combinators.combine(shot, Arbitraries.integers().between(0, LAST), NumberArbitraries.range(Shot.MIN_RATE, Shot.MAX_RATE))
                .as((s, first, rate) -> new Shot(first, LAST, rate, s.tracks()));
    }

    private static List<SceneElement<?>> targets(Scene scene) {
        Set<String> outer = scene.nodes().stream().map(SceneNode::name).collect(Collectors.toSet());
        return Stream.concat(Stream.of(SceneElement.CAMERA, SceneElement.WORLD), SceneElement.named(scene).filter(
                e -> !(e instanceof SceneElement.OfMaterial) && (!(e instanceof SceneElement.OfNode) || outer.contains(e.name()))))
                .toList();
    }

    private static Arbitrary<Track> tracks(SceneElement<?> target, SceneAttribute<?, ?> attribute) {
        return Arbitraries.integers().between(0, LAST).list().ofMinSize(1).ofMaxSize(5).map(TreeSet::new)
                .flatMap(frames -> Combinators.combine(keyframeValues(attribute.kind()).list().ofSize(frames.size()),
                        interpolations(attribute.kind()).list().ofSize(frames.size())).as((settings, passages) -> {
                            List<Keyframe> keys = new ArrayList<>();
                            for (int frame : frames) {
                                keys.add(new Keyframe(frame, settings.get(keys.size()), passages.get(keys.size())));
                            }
                            return new Track(target, attribute.name(), keys);
                        }));
    }

    private static Arbitrary<Interpolation> interpolations(ValueKind<?> kind) {
        return kind.keyframeSupport() == KeyframeSupport.STEPPED ? Arbitraries.just(Interpolation.STEPPED)
                : Arbitraries.of(Interpolation.values());
    }

    private static <V> Arbitrary<KeyframeValue> keyframeValues(ValueKind<V> kind) {
        return switch (kind) {
            case NumericKind<V> q -> AttributeArbitraries.numbers(q).filter(v -> isAllowed(q, v))
                    .map(v -> new KeyframeValue.Numbers(q.components().apply(v)));
            case ChoiceKind<V> c -> Arbitraries.of(c.words()).map(KeyframeValue.Word::new);
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.TextureKind _ ->
                    throw new IllegalArgumentException("no keys");
        };
    }

    private static <V> boolean isAllowed(NumericKind<V> q, V value) {
        try {
            q.check("value", value);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }
}
