package lightning.format.jen;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.scene.ShapeLinks;

/** What follows a property's name in the file. Two values are equal when every bit is. */
sealed interface Value {
    /** The text that reads back as this value. */
    String text();

    record Numbers(List<Double> values) implements Value {
        public Numbers {
            values = List.copyOf(values);
        }

        @Override
        public String text() {
            return values.stream().map(DecimalNumber::format).collect(Collectors.joining(" "));
        }
    }

    /** One of the words that a property may be. */
    record Word(String text) implements Value {}

    /** The name of something in the scene, in quotes where it is no word. */
    record Name(String name) implements Value {
        @Override
        public String text() {
            return NameSyntax.format(name);
        }
    }

    /** A file's name, written in quotes. */
    record Quoted(String file) implements Value {
        @Override
        public String text() {
            return '"' + file + '"';
        }
    }

    /** Some shapes and groups, their names always in quotes: how many there are, the file does not say. */
    record LinkSet(ShapeLinks links) implements Value {
        @Override
        public String text() {
            return links.isAll() ? ALL : links.equals(ShapeLinks.NONE) ? NONE
                    : links.names().stream().map(NameSyntax::quote)
                            .collect(Collectors.joining(" ", (links.exclusive() ? ONLY : EXCEPT) + ' ', ""));
        }
    }

    String ALL = "all";
    String NONE = "none";
    String ONLY = "only";
    String EXCEPT = "except";

    /** Nothing is written: the property is absent. */
    record Absent() implements Value {
        @Override
        public String text() {
            return "";
        }
    }

    static Value of(double... numbers) {
        return new Numbers(Arrays.stream(numbers).boxed().toList());
    }

    static Value of(Vec3 v) {
        return of(v.x(), v.y(), v.z());
    }
}
