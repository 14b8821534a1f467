package lightning.format.gltf;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.MissingNode;

/**
 * A value in a file of JSON, which knows its place: every problem names it, as in {@code accessors[3].count}.
 *
 * @param path from the root; empty at the root
 */
record Json(Path file, String path, JsonNode node) {
    MeshException problem(String message) {
        return new MeshException(file, path, message);
    }

    boolean isThere() {
        return !node.isMissingNode();
    }

    /** A property, which need not be there. */
    Json get(String name) throws MeshException {
        if (isThere() && !node.isObject()) {
            throw problem("must be an object, was " + shown());
        }
        JsonNode value = node.get(name);
        return new Json(file, path.isEmpty() ? name : path + "." + name, value == null ? MissingNode.getInstance() : value);
    }

    /** How many values an array has; 0 where there is none. */
    int size() throws MeshException {
        if (isThere() && !node.isArray()) {
            throw problem("must be an array, was " + shown());
        }
        return node.size();
    }

    /** A value of an array, which must be there. */
    Json at(int index) throws MeshException {
        if (index < 0 || index >= size()) {
            throw problem("must have a value " + index + ", has " + size());
        }
        return new Json(file, path + "[" + index + "]", node.get(index));
    }

    /** The value of {@code array} that this whole number names. */
    Json in(Json array) throws MeshException {
        return array.at(index(array));
    }

    /** This whole number, which names a value of {@code array}. */
    int index(Json array) throws MeshException {
        if (array.size() == 0) {
            throw problem("there are no " + array.path);
        }
        return whole(0, array.size() - 1);
    }

    int whole(int min, int max) throws MeshException {
        double value = value();
        if (!(value >= min && value <= max) || value != Math.rint(value)) {
            throw problem("must be a whole number from " + min + " to " + max + ", was " + shown());
        }
        return (int) value;
    }

    int whole(int min, int max, int otherwise) throws MeshException {
        return isThere() ? whole(min, max) : otherwise;
    }

    double number() throws MeshException {
        double value = value();
        if (Double.isNaN(value)) {
            throw problem("must be a number, was " + shown());
        }
        if (Double.isInfinite(value)) {
            throw problem("must be a number of at most 1.8e308, was " + shown());
        }
        return value;
    }

    /** The nearest double, which is infinite beyond the range of doubles; NaN where this is no number. */
    private double value() {
        return node.isNumber() ? node.numberValue().doubleValue() : Double.NaN;
    }

    double number(double otherwise) throws MeshException {
        return isThere() ? number() : otherwise;
    }

    boolean yes(boolean otherwise) throws MeshException {
        if (isThere() && !node.isBoolean()) {
            throw problem("must be true or false, was " + shown());
        }
        return isThere() ? node.asBoolean() : otherwise;
    }

    Optional<String> text() throws MeshException {
        if (isThere() && !node.isString()) {
            throw problem("must be text in quotes, was " + shown());
        }
        return isThere() ? Optional.of(node.asString()) : Optional.empty();
    }

    /** So many numbers, or those given where there are none. */
    double[] numbers(double... otherwise) throws MeshException {
        if (!isThere()) {
            return otherwise;
        }
        if (size() != otherwise.length) {
            throw problem("must have " + otherwise.length + " numbers, has " + size());
        }
        double[] numbers = new double[otherwise.length];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = at(i).number();
        }
        return numbers;
    }

    private String shown() {
        if (!isThere()) {
            return "missing";
        }
        return node.isObject() ? "an object" : node.isArray() ? "an array" : Quote.of(node.asString(""));
    }
}
