package lightning.format.gltf;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.format.mesh.LimitException;
import lightning.format.mesh.MeshException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.MissingNode;

/**
 * JSON value with its path, which every problem contains, such as {@code accessors[3].count}.
 *
 * @param path path from the root; empty at the root
 */
public record JsonValue(Path file, String path, JsonNode node) {
    /** Creates a problem that no reader may skip. */
    LimitException limit(String message) {
        return new LimitException(file, path, message);
    }

    public MeshException problem(String message) {
        return new MeshException(file, path, message);
    }

    public boolean isPresent() {
        return !node.isMissingNode();
    }

    /** Returns a property, possibly absent. */
    public JsonValue get(String name) throws MeshException {
        if (isPresent() && !node.isObject()) {
            throw problem("must be an object, was " + describe());
        }
        JsonNode value = node.get(name);
        return new JsonValue(file, path.isEmpty() ? name : path + "." + name, value == null ? MissingNode.getInstance() : value);
    }

    /** Returns the length of an array; 0 if absent. */
    public int size() throws MeshException {
        if (isPresent() && !node.isArray()) {
            throw problem("must be an array, was " + describe());
        }
        return node.size();
    }

    /** Returns an element of an array; throws if it is absent. */
    public JsonValue element(int index) throws MeshException {
        if (index < 0 || index >= size()) {
            throw problem("must have a value " + index + ", has " + size());
        }
        return new JsonValue(file, path + "[" + index + "]", node.get(index));
    }

    /** Returns the element of {@code array} at the index that this value contains. */
    public JsonValue resolve(JsonValue array) throws MeshException {
        return array.element(index(array));
    }

    /** Returns this value as an index into {@code array}. */
    public int index(JsonValue array) throws MeshException {
        if (array.size() == 0) {
            throw problem("missing " + array.path);
        }
        return integer(0, array.size() - 1);
    }

    public int integer(int min, int max) throws MeshException {
        double value = numericValue();
        if (!(value >= min && value <= max) || value != Math.rint(value)) {
            throw problem("must be a whole number from " + min + " to " + max + ", was " + describe());
        }
        return (int) value;
    }

    public int integer(int min, int max, int fallback) throws MeshException {
        return isPresent() ? integer(min, max) : fallback;
    }

    public double number() throws MeshException {
        double value = numericValue();
        if (Double.isNaN(value)) {
            throw problem("must be a number, was " + describe());
        }
        if (Double.isInfinite(value)) {
            throw problem("must be a number of at most 1.8e308, was " + describe());
        }
        return value;
    }

    /** Returns the nearest double, infinite if out of range; NaN if this is not a number. */
    private double numericValue() {
        return node.isNumber() ? node.numberValue().doubleValue() : Double.NaN;
    }

    public double number(double fallback) throws MeshException {
        return isPresent() ? number() : fallback;
    }

    public boolean bool(boolean fallback) throws MeshException {
        if (isPresent() && !node.isBoolean()) {
            throw problem("must be true or false, was " + describe());
        }
        return isPresent() ? node.asBoolean() : fallback;
    }

    public Optional<String> text() throws MeshException {
        if (isPresent() && !node.isString()) {
            throw problem("must be text in quotes, was " + describe());
        }
        return isPresent() ? Optional.of(node.asString()) : Optional.empty();
    }

    /** Returns an array of numbers of the fallback's length, or the fallback if absent. */
    public double[] numbers(double... fallback) throws MeshException {
        if (!isPresent()) {
            return fallback;
        }
        if (size() != fallback.length) {
            throw problem("must have " + fallback.length + " numbers, has " + size());
        }
        double[] numbers = new double[fallback.length];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = element(i).number();
        }
        return numbers;
    }

    private String describe() {
        if (!isPresent()) {
            return "missing";
        }
        return node.isObject() ? "an object" : node.isArray() ? "an array" : Quote.of(node.asString(""));
    }
}
