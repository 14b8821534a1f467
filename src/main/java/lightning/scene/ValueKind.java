package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Messages;

/**
 * What values an {@link SceneAttribute} has.
 *
 * @param <V> the type of a value
 */
public sealed interface ValueKind<V> permits ValueKind.LightKind, ValueKind.MaterialKind {

    /** Values that a light can have: each kind has a control in the editor. */
    sealed interface LightKind<V> extends ValueKind<V> permits NumericKind, ChoiceKind, AssetKind, LinksKind, NameKind {}

    /** Values that a material can have: each kind has a control in the editor. */
    sealed interface MaterialKind<V> extends ValueKind<V> permits NumericKind, ChoiceKind, TextureKind {}

    /**
     * Refuses a value that no scene may hold.
     *
     * @param name the attribute's name in the message
     * @throws IllegalArgumentException if it is out of its range; the message says what was expected and found
     */
    void check(String name, V value);

    /** Whether two values do the same wherever they act. */
    boolean isEquivalent(V a, V b);

    /** A value for people. */
    String format(V value);

    /** What values of this kind do between two keys of a shot. */
    default KeyframeSupport keyframeSupport() {
        return switch (this) {
            case NumericKind<V> n -> n.integer() ? KeyframeSupport.STEPPED : KeyframeSupport.INTERPOLATED;
            case ChoiceKind<V> _ -> KeyframeSupport.STEPPED;
            case AssetKind<?> _,LinksKind _,NameKind _,TextureKind _ -> KeyframeSupport.NONE;
        };
    }

    /**
     * The name of something in the scene, or none, which is empty.
     *
     * @param names the names in a scene
     * @param help  a key of {@link Messages}: a sentence without a full stop
     */
    record NameKind(Function<Scene, List<String>> names, String help) implements LightKind<String> {
        @Override
        public void check(String name, String value) {
            if (!value.isEmpty()) {
                SceneLimits.checkName(value);
            }
        }

        @Override
        public boolean isEquivalent(String a, String b) {
            return a.equals(b);
        }

        @Override
        public String format(String value) {
            return value.isEmpty() ? "none" : value;
        }
    }

    /**
     * Some of the scene's shapes.
     *
     * @param caption a key of {@link Messages}: what stands above the control
     * @param help    a key of {@link Messages}: a sentence without a full stop
     */
    record LinksKind(String caption, String help) implements LightKind<ShapeLinks> {
        @Override
        public void check(String name, ShapeLinks value) {
            // All links have checked themselves.
        }

        @Override
        public boolean isEquivalent(ShapeLinks a, ShapeLinks b) {
            return a.equals(b);
        }

        @Override
        public String format(ShapeLinks value) {
            return value.format();
        }
    }

    /** What a file holds, or none. */
    sealed interface AssetKind<F extends FileAsset> extends LightKind<Optional<F>> {
        @Override
        default void check(String name, Optional<F> value) {
            // Every file was checked when it was read.
        }

        @Override
        default boolean isEquivalent(Optional<F> a, Optional<F> b) {
            return a.map(FileAsset::content).equals(b.map(FileAsset::content));
        }

        @Override
        default String format(Optional<F> value) {
            return value.map(FileAsset::file).orElse("none");
        }
    }

    /** A picture that is projected, or none. */
    record GoboKind() implements AssetKind<Gobo> {}

    /** How strongly a light shines in each direction, or the same in all. */
    record ProfileKind() implements AssetKind<IesProfile> {}

    /** A picture of all that is far around, or none. */
    record EnvironmentKind() implements AssetKind<Environment> {}

    /**
     * A picture on a surface, or none.
     *
     * @param repeatName  what a file calls how often it repeats
     * @param usage what its samples stand for
     */
    record TextureKind(String repeatName, TextureUsage usage) implements MaterialKind<Optional<TextureMap>> {
        @Override
        public void check(String name, Optional<TextureMap> value) {
            // Every map has checked itself.
        }

        @Override
        public boolean isEquivalent(Optional<TextureMap> a, Optional<TextureMap> b) {
            return a.isPresent() == b.isPresent() && (a.isEmpty() || a.get().hasSameTexels(b.get()));
        }

        @Override
        public String format(Optional<TextureMap> value) {
            return value.map(t -> t.file() + " " + NumericKind.formatShort(t.repeatU()) + " × " + NumericKind.formatShort(t.repeatV()))
                    .orElse("none");
        }
    }
}
