package lightning.scene.attribute;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.file.ContentDigest;
import lightning.base.text.Messages;
import lightning.scene.asset.Environment;
import lightning.scene.asset.FileAsset;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureUsage;
import lightning.scene.asset.TextureWrap;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/**
 * Kind of values of a {@link SceneAttribute}: range, comparison and format.
 *
 * @param <V> type of the values
 */
public sealed interface ValueKind<V> permits ValueKind.LightKind, ValueKind.MaterialKind {

    /** Kinds of a light's attributes; the editor has a control for each. */
    sealed interface LightKind<V> extends ValueKind<V> permits NumericKind, ChoiceKind, AssetKind, LinksKind, GainsKind, NameKind {}

    /** Kinds of a material's attributes; the editor has a control for each. */
    sealed interface MaterialKind<V> extends ValueKind<V> permits NumericKind, ChoiceKind, NameKind, TextureKind {}

    /**
     * Checks that a scene may hold a value.
     *
     * @param name the attribute's name in the message
     * @throws IllegalArgumentException if it is out of range; the message has the expected and the actual value
     */
    default void check(String name, V value) {
        // Most values are checked when they are made or read.
    }

    /** Returns whether two values have the same effect. */
    default boolean isEquivalent(V a, V b) {
        return a.equals(b);
    }

    /** Formats a value for the user. */
    String format(V value);

    /** Returns the name of the file that a value refers to, as in the scene file; empty if there is none. */
    default Optional<String> file(V value) {
        return Optional.empty();
    }

    /** Returns the content of that file. */
    default Optional<? extends ContentDigest.Content> content(V value) {
        return Optional.empty();
    }

    /**
     * Returns a value that refers to its file by another name.
     *
     * @param newName returns the new name for the old one
     */
    default V renameFile(V value, UnaryOperator<String> newName) {
        return value;
    }

    /** Returns the behavior of values of this kind between keyframes. */
    default KeyframeSupport keyframeSupport() {
        return switch (this) {
            case NumericKind<V> n -> n.integer() ? KeyframeSupport.STEPPED : KeyframeSupport.INTERPOLATED;
            case ChoiceKind<V> _ -> KeyframeSupport.STEPPED;
            case AssetKind<?> _,LinksKind _,GainsKind _,NameKind _,TextureKind _ -> KeyframeSupport.NONE;
        };
    }

    /**
     * Name of an object in the scene; empty for none.
     *
     * @param referent what has the name
     * @param help     a key of {@link Messages}: a sentence without a full stop
     */
    record NameKind(Referent referent, String help) implements LightKind<String>, MaterialKind<String> {
        /** What a name refers to. */
        public enum Referent {
            LIGHT,
            LIGHT_GROUP,
            SHAPE
        }

        @Override
        public void check(String name, String value) {
            if (!value.isEmpty()) {
                SceneLimits.checkName(value);
            }
        }

        @Override
        public String format(String value) {
            return value.isEmpty() ? "none" : value;
        }
    }

    /**
     * Links to shapes of the scene.
     *
     * @param caption a key of {@link Messages}: the label above the control
     * @param help    a key of {@link Messages}: a sentence without a full stop
     */
    record LinksKind(String caption, String help) implements LightKind<ShapeLinks> {
        @Override
        public String format(ShapeLinks value) {
            return value.format();
        }
    }

    /**
     * Gains on shapes of the scene.
     *
     * @param help a key of {@link Messages}: a sentence without a full stop
     */
    record GainsKind(String help) implements LightKind<ShapeGains> {
        @Override
        public String format(ShapeGains value) {
            return value.format();
        }
    }

    /** Optional file with its content. */
    sealed interface AssetKind<F extends FileAsset> extends LightKind<Optional<F>> {
        @Override
        default boolean isEquivalent(Optional<F> a, Optional<F> b) {
            return content(a).equals(content(b));
        }

        @Override
        default String format(Optional<F> value) {
            return value.map(FileAsset::file).orElse("none");
        }

        @Override
        default Optional<String> file(Optional<F> value) {
            return value.map(FileAsset::file);
        }

        @Override
        default Optional<? extends ContentDigest.Content> content(Optional<F> value) {
            return value.map(FileAsset::content);
        }

        @Override
        default Optional<F> renameFile(Optional<F> value, UnaryOperator<String> newName) {
            return value.map(asset -> withFile(asset, newName.apply(asset.file())));
        }

        /** Returns an asset of another file name with the same content. */
        F withFile(F asset, String file);
    }

    /** Optional gobo image. */
    record GoboKind() implements AssetKind<Gobo> {
        @Override
        public Gobo withFile(Gobo asset, String file) {
            return new Gobo(file, asset.image());
        }
    }

    /** Optional IES profile; without it the light is uniform. */
    record ProfileKind() implements AssetKind<IesProfile> {
        @Override
        public IesProfile withFile(IesProfile asset, String file) {
            return new IesProfile(file, asset.photometry());
        }
    }

    /** Optional image on the face of an area light. */
    record LightTextureKind() implements AssetKind<LightTexture> {
        @Override
        public LightTexture withFile(LightTexture asset, String file) {
            return new LightTexture(file, asset.image());
        }
    }

    /** Optional environment map. */
    record EnvironmentKind() implements AssetKind<Environment> {
        @Override
        public Environment withFile(Environment asset, String file) {
            return new Environment(file, asset.map());
        }
    }

    /**
     * Optional texture.
     *
     * @param repeatName keyword of its repetition in a file
     * @param usage      meaning of its samples
     */
    record TextureKind(String repeatName, TextureUsage usage) implements MaterialKind<Optional<TextureMap>> {
        /** Continuations of an image beyond its edges. */
        public static final ChoiceKind<TextureWrap> WRAP =
                new ChoiceKind<>(TextureWrap.ALL, TextureWrap.ALL.stream().map(TextureWrap::word).toList(),
                        List.of(Messages.key("repeat"), Messages.key("clamp"), Messages.key("mirror"), Messages.key("repeat, clamp"),
                                Messages.key("repeat, mirror"), Messages.key("clamp, repeat"), Messages.key("clamp, mirror"),
                                Messages.key("mirror, repeat"), Messages.key("mirror, clamp")));

        /**
         * Returns the attributes of the image's placement, which have no effect without it.
         *
         * @param texture attribute of this kind
         */
        // Attributes of this kind have one type of values.
        @SuppressWarnings("unchecked")
        public <T> List<SceneAttribute<T, ?>> placement(SceneAttribute<T, ?> texture) {
            return PlacementAttribute.of((SceneAttribute<T, Optional<TextureMap>>) texture, repeatName);
        }

        @Override
        public boolean isEquivalent(Optional<TextureMap> a, Optional<TextureMap> b) {
            return a.isPresent() == b.isPresent() && (a.isEmpty() || a.get().hasSameTexels(b.get()));
        }

        @Override
        public String format(Optional<TextureMap> value) {
            return value.map(t -> t.file() + " " + SceneLimits.formatShort(t.repeatU()) + " × " + SceneLimits.formatShort(t.repeatV())
                    + (t.wrap().equals(TextureWrap.REPEAT) ? "" : " " + t.wrap().word()) + format(t.placement()))
                    .orElse("none");
        }

        private static String format(TexturePlacement p) {
            return p.isNone() ? "" : " + " + SceneLimits.formatShort(p.offsetU()) + " " + SceneLimits.formatShort(p.offsetV()) + " "
                    + SceneLimits.formatShort(p.rotation()) + "°";
        }

        @Override
        public Optional<String> file(Optional<TextureMap> value) {
            return value.map(TextureMap::file);
        }

        @Override
        public Optional<? extends ContentDigest.Content> content(Optional<TextureMap> value) {
            return value.map(TextureMap::image);
        }

        @Override
        public Optional<TextureMap> renameFile(Optional<TextureMap> value, UnaryOperator<String> newName) {
            return value.map(map -> map.withFile(newName.apply(map.file())));
        }
    }
}
