package lightning.format.exchange.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.StreamSupport;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.FileKind;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.FileAsset;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.Photometry;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * JSON form of the attributes of lights, light groups and worlds, by their {@code .jen} names. A single number is a number, several
 * numbers are an array, a choice is its word or a boolean, a file is its name, links are {@code {"only": …, "names": […]}},
 * and gains {@code {"name": factor, …}}.
 */
public final class AttributeJson {
    private AttributeJson() {}

    /** Returns whether the scene can find a file that a light references. */
    public interface FileLookup {
        boolean contains(FileKind kind, String name);
    }

    /** Writes all attributes of a table; omits absent files. */
    public static <T> void write(ObjectNode out, T record, List<? extends SceneAttribute<T, ?>> attributes) {
        attributes.forEach(attribute -> write(out, record, attribute));
    }

    private static <T, V> void write(ObjectNode out, T record, SceneAttribute<T, V> attribute) {
        V value = attribute.get(record);
        String name = attribute.name();
        switch (attribute.kind()) {
            case NumericKind<V> q when q.labels().size() == 1 -> number(out, name, q.number(value, 0), q.integer());
            case NumericKind<V> q -> q.components().apply(value).forEach(out.withArray(name)::add);
            case ChoiceKind<V> _ when value instanceof Boolean yes -> out.put(name, yes);
            case ChoiceKind<V> c -> out.put(name, c.format(value));
            case ValueKind.LinksKind _ -> links(out.putObject(name), (ShapeLinks) value);
            case ValueKind.GainsKind _ -> gains(out.putObject(name), (ShapeGains) value);
            case ValueKind.NameKind _ -> out.put(name, (String) value);
            case ValueKind.AssetKind<?> _ -> ((Optional<?>) value).ifPresent(file -> out.put(name, ((FileAsset) file).file()));
            case ValueKind.TextureKind _ -> ((Optional<?>) value).ifPresent(map -> out.put(name, ((TextureMap) map).file()));
        }
    }

    private static void number(ObjectNode out, String name, double value, boolean whole) {
        if (whole) {
            out.put(name, (int) value);
        } else {
            out.put(name, value);
        }
    }

    private static void links(ObjectNode out, ShapeLinks links) {
        ArrayNode names = out.put("only", links.exclusive()).putArray("names");
        links.names().forEach(names::add);
    }

    private static void gains(ObjectNode out, ShapeGains gains) {
        gains.entries().forEach(e -> out.put(e.name(), e.gain()));
    }

    /**
     * Returns the record with every attribute that is present in the JSON and applicable.
     *
     * @param onError receives a message for each invalid value; the attribute then keeps its value
     */
    public static <T> T read(JsonNode in, T record, List<? extends SceneAttribute<T, ?>> attributes, FileLookup files,
            Consumer<String> onError) {
        T result = record;
        for (SceneAttribute<T, ?> attribute : attributes) {
            if (in.has(attribute.name())) {
                try {
                    result = withValue(result, attribute, in.get(attribute.name()), files);
                } catch (RefusalException e) {
                    onError.accept(e.getMessage());
                }
            }
        }
        return result;
    }

    private static <T, V> T withValue(T record, SceneAttribute<T, V> attribute, JsonNode in, FileLookup files) {
        return attribute.with(record, value(attribute.kind(), in, files));
    }

    @SuppressWarnings("unchecked")
    private static <V> V value(ValueKind<V> kind, JsonNode in, FileLookup files) {
        return switch (kind) {
            case NumericKind<V> q -> quantity(q, in);
            case ChoiceKind<V> c -> choice(c, in);
            case ValueKind.LinksKind _ -> (V) links(in);
            case ValueKind.GainsKind _ -> (V) gains(in);
            case ValueKind.NameKind _ -> (V) text(in);
            case ValueKind.GoboKind _ -> (V) Optional.of(new Gobo(file(FileKind.TEXTURE, in, files),
                    new Texture(1, 1, new float[] {1, 1, 1})));
            case ValueKind.LightTextureKind _ -> (V) Optional.of(new LightTexture(file(FileKind.TEXTURE, in, files),
                    new Texture(1, 1, new float[] {1, 1, 1})));
            case ValueKind.ProfileKind _ -> (V) Optional.of(new IesProfile(file(FileKind.PROFILE, in, files),
                    new Photometry(Photometry.Type.C, new double[] {0, 180}, new double[] {0}, new double[] {1, 1})));
            case ValueKind.EnvironmentKind _ -> (V) Optional.of(new Environment(file(FileKind.ENVIRONMENT, in, files),
                    new EnvironmentMap(2, 1, new float[6])));
            case ValueKind.TextureKind _ -> throw new AssertionError("no light has a texture");
        };
    }

    private static <V> V quantity(NumericKind<V> q, JsonNode in) {
        List<Double> numbers = new ArrayList<>();
        for (JsonNode number : in.isArray() ? in : List.of(in)) {
            if (!number.isNumber() || numbers.size() == q.labels().size()) {
                throw new RefusalException("expected " + q.labels().size() + " numbers");
            }
            double value = number.numberValue().doubleValue();
            q.check("it", value);
            numbers.add(value);
        }
        if (numbers.size() < q.labels().size()) {
            throw new RefusalException("expected " + q.labels().size() + " numbers, found " + numbers.size());
        }
        return q.compose().apply(numbers);
    }

    private static <V> V choice(ChoiceKind<V> choice, JsonNode in) {
        for (V value : choice.values()) {
            if (value instanceof Boolean yes ? in.isBoolean() && in.asBoolean() == yes : choice.format(value).equals(text(in))) {
                return value;
            }
        }
        throw new RefusalException("expected one of " + String.join(", ", choice.words()));
    }

    private static ShapeLinks links(JsonNode in) {
        if (!in.path("only").isBoolean() || !in.path("names").isArray()) {
            throw new RefusalException("expected only and names");
        }
        return new ShapeLinks(in.get("only").asBoolean(), StreamSupport.stream(in.get("names").spliterator(), false)
                .map(AttributeJson::text).toList());
    }

    private static ShapeGains gains(JsonNode in) {
        if (!in.isObject() || !in.values().stream().allMatch(JsonNode::isNumber)) {
            throw new RefusalException("expected a number for each name");
        }
        return new ShapeGains(in.properties().stream()
                .map(e -> new ShapeGains.Entry(e.getKey(), e.getValue().numberValue().doubleValue())).toList());
    }

    private static String text(JsonNode in) {
        if (!in.isString()) {
            throw new RefusalException("expected text");
        }
        return in.asString();
    }

    /** Returns a placeholder for a file; its content is read with the scene. */
    private static String file(FileKind kind, JsonNode in, FileLookup files) {
        String name = text(in);
        if (!files.contains(kind, name)) {
            throw new RefusalException("there is no file " + Quote.of(name));
        }
        return name;
    }
}
