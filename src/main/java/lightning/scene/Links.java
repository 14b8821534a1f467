package lightning.scene;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.base.text.Texts;

/**
 * Which shapes something of a light concerns: those named alone, or all but those. The name of a group stands for all shapes in it.
 * {@link Stage#linked} tells which they are.
 *
 * @param only  whether none but those named are meant
 * @param names of shapes and groups, each once; a name that the scene does not have stands for nothing
 */
public record Links(boolean only, List<String> names) {
    /** Every shape. */
    public static final Links ALL = new Links(false, List.of());
    /** No shape. */
    public static final Links NONE = new Links(true, List.of());

    /**
     * @throws IllegalArgumentException if a name is none that a shape can have, or if there are more than {@link Limits#MAX_LINKS}
     */
    public Links {
        names = List.copyOf(new LinkedHashSet<>(names));
        Limits.range("the number of linked shapes", names.size(), 0, Limits.MAX_LINKS);
        names.forEach(Limits::name);
    }

    public static Links only(String... names) {
        return new Links(true, List.of(names));
    }

    public static Links except(String... names) {
        return new Links(false, List.of(names));
    }

    /** Whether no shape is left out. */
    public boolean isAll() {
        return !only && names.isEmpty();
    }

    /** These links where a shape or a group has another name. */
    public Links renamed(String from, String to) {
        return !names.contains(from) ? this : new Links(only, names.stream().map(n -> n.equals(from) ? to : n).toList());
    }

    /** These links without names that are not known. */
    public Links within(Predicate<String> known) {
        return names.stream().allMatch(known) ? this : new Links(only, names.stream().filter(known).toList());
    }

    /** These links with one name more, the last, or without it. */
    public Links with(String name, boolean named) {
        List<String> all = new ArrayList<>(names);
        all.remove(name);
        if (named) {
            all.add(name);
        }
        return new Links(only, all);
    }

    /** For people: {@code all}, {@code none}, {@code only a, b} or {@code all but a, b}. */
    public String text() {
        String list = names.stream().map(Quote::of).collect(Collectors.joining(", "));
        return isAll() ? Texts.of("all") : equals(NONE) ? Texts.of("none") : only ? Texts.of("only {0}", list)
                : Texts.of("all but {0}", list);
    }
}
