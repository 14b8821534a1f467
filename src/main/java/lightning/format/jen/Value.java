package lightning.format.jen;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/** Value of a property in the file. Values are equal if they are bit-identical. */
sealed interface Value {
    /** Returns the text that reads back as this value. */
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

    /** Word from the property's choices. */
    record Word(String text) implements Value {}

    /** Name of a scene object, in quotes unless it is a word. */
    record Name(String name) implements Value {
        @Override
        public String text() {
            return NameSyntax.format(name);
        }
    }

    /** File name, written in quotes. */
    record Quoted(String file) implements Value {
        @Override
        public String text() {
            return NameSyntax.quote(file);
        }
    }

    /** Shapes and groups of a light link, with names always in quotes; the file contains no count. */
    record LinkSet(ShapeLinks links) implements Value {
        @Override
        public String text() {
            return links.isAll() ? ALL : links.equals(ShapeLinks.NONE) ? NONE
                    : links.names().stream().map(NameSyntax::quote)
                            .collect(Collectors.joining(" ", (links.exclusive() ? ONLY : EXCEPT) + ' ', ""));
        }
    }

    /** Gains of a light on shapes and groups: names in quotes, each followed by a number. */
    record Gains(ShapeGains gains) implements Value {
        @Override
        public String text() {
            return gains.entries().stream().map(e -> NameSyntax.quote(e.name()) + ' ' + DecimalNumber.format(e.gain()))
                    .collect(Collectors.joining(" "));
        }
    }

    /** Properties of a nested block, in braces. */
    record Nested(BlockContent content) implements Value {
        @Override
        public String text() {
            return JenWriter.braces(JenWriter.properties(content));
        }
    }

    String ALL = "all";
    String NONE = "none";
    String ONLY = "only";
    String EXCEPT = "except";

    /** Absent property. */
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
