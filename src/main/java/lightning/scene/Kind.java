package lightning.scene;

import java.util.Optional;

/**
 * What values an {@link Attribute} has.
 *
 * @param <V> the type of a value
 */
public sealed interface Kind<V> permits Quantity, Choice, Kind.Naming, Kind.Projecting, Kind.Texturing {

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

    /** The name of something in the scene, or none, which is empty. */
    record Naming() implements Kind<String> {
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

    /** A picture that is projected, or none. */
    record Projecting() implements Kind<Optional<Gobo>> {
        @Override
        public void check(String what, Optional<Gobo> value) {
            // Every picture has checked itself.
        }

        @Override
        public boolean alike(Optional<Gobo> a, Optional<Gobo> b) {
            return a.map(Gobo::image).equals(b.map(Gobo::image));
        }

        @Override
        public String text(Optional<Gobo> value) {
            return value.map(Gobo::file).orElse("none");
        }
    }

    /** A picture on a surface, or none. */
    record Texturing() implements Kind<Optional<TextureMap>> {
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
