package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Texts;

/**
 * What values an {@link Attribute} has.
 *
 * @param <V> the type of a value
 */
public sealed interface ValueKind<V> permits ValueKind.OfLight, ValueKind.OfMaterial {

    /** Values that a light can have: each kind has a control in the editor. */
    sealed interface OfLight<V> extends ValueKind<V> permits Quantity, Choice, Filed, Linking, Naming {}

    /** Values that a material can have: each kind has a control in the editor. */
    sealed interface OfMaterial<V> extends ValueKind<V> permits Quantity, Choice, Texturing {}

    /**
     * Refuses a value that no scene may hold.
     *
     * @param what the attribute's name in the message
     * @throws IllegalArgumentException if it is out of its range; the message says what was expected and found
     */
    void check(String what, V value);

    /** Whether two values do the same wherever they act. */
    boolean alike(V a, V b);

    /** A value for people. */
    String text(V value);

    /** What values of this kind do between two keys of a shot. */
    default Keying keying() {
        return switch (this) {
            case Quantity<V> n -> n.whole() ? Keying.HOLDS : Keying.GLIDES;
            case Choice<V> _ -> Keying.HOLDS;
            case Filed<?> _,Linking _,Naming _,Texturing _ -> Keying.NONE;
        };
    }

    /**
     * The name of something in the scene, or none, which is empty.
     *
     * @param names the names in a scene
     * @param help  a key of {@link Texts}: a sentence without a full stop
     */
    record Naming(Function<Scene, List<String>> names, String help) implements OfLight<String> {
        @Override
        public void check(String what, String value) {
            if (!value.isEmpty()) {
                Limits.name(value);
            }
        }

        @Override
        public boolean alike(String a, String b) {
            return a.equals(b);
        }

        @Override
        public String text(String value) {
            return value.isEmpty() ? "none" : value;
        }
    }

    /**
     * Some of the scene's shapes.
     *
     * @param caption a key of {@link Texts}: what stands above the control
     * @param help    a key of {@link Texts}: a sentence without a full stop
     */
    record Linking(String caption, String help) implements OfLight<Links> {
        @Override
        public void check(String what, Links value) {
            // All links have checked themselves.
        }

        @Override
        public boolean alike(Links a, Links b) {
            return a.equals(b);
        }

        @Override
        public String text(Links value) {
            return value.text();
        }
    }

    /** What a file holds, or none. */
    sealed interface Filed<F extends FromFile> extends OfLight<Optional<F>> {
        @Override
        default void check(String what, Optional<F> value) {
            // Every file was checked when it was read.
        }

        @Override
        default boolean alike(Optional<F> a, Optional<F> b) {
            return a.map(FromFile::content).equals(b.map(FromFile::content));
        }

        @Override
        default String text(Optional<F> value) {
            return value.map(FromFile::file).orElse("none");
        }
    }

    /** A picture that is projected, or none. */
    record Projecting() implements Filed<Gobo> {}

    /** How strongly a light shines in each direction, or the same in all. */
    record Shining() implements Filed<Profile> {}

    /** A picture of all that is far around, or none. */
    record Surrounding() implements Filed<Panorama> {}

    /**
     * A picture on a surface, or none.
     *
     * @param repeat  what a file calls how often it repeats
     * @param samples what its samples stand for
     */
    record Texturing(String repeat, SampleMeaning samples) implements OfMaterial<Optional<TextureMap>> {
        @Override
        public void check(String what, Optional<TextureMap> value) {
            // Every map has checked itself.
        }

        @Override
        public boolean alike(Optional<TextureMap> a, Optional<TextureMap> b) {
            return a.isPresent() == b.isPresent() && (a.isEmpty() || a.get().hasTexelsOf(b.get()));
        }

        @Override
        public String text(Optional<TextureMap> value) {
            return value.map(t -> t.file() + " " + Quantity.digits(t.repeatU()) + " × " + Quantity.digits(t.repeatV())).orElse("none");
        }
    }
}
