package lightning.scene;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lightning.base.text.Messages;
import lightning.base.text.Quote;

/**
 * Which shapes something of a light concerns: those named alone, or all but those. The name of a group stands for all shapes in it.
 * {@link Stage#linkMask} tells which they are.
 *
 * @param exclusive  whether none but those named are meant
 * @param names of shapes and groups, each once; a name that the scene does not have stands for nothing
 */
public record ShapeLinks(boolean exclusive, List<String> names) {
    /** Every shape. */
    public static final ShapeLinks ALL = new ShapeLinks(false, List.of());
    /** No shape. */
    public static final ShapeLinks NONE = new ShapeLinks(true, List.of());

    /**
     * @throws IllegalArgumentException if a name is none that a shape can have, or if there are more than {@link SceneLimits#MAX_LINKS}
     */
    public ShapeLinks {
        names = List.copyOf(new LinkedHashSet<>(names));
        SceneLimits.checkRange("the number of linked shapes", names.size(), 0, SceneLimits.MAX_LINKS);
        names.forEach(SceneLimits::checkName);
    }

    public static ShapeLinks only(String... names) {
        return new ShapeLinks(true, List.of(names));
    }

    public static ShapeLinks except(String... names) {
        return new ShapeLinks(false, List.of(names));
    }

    /** Whether no shape is left out. */
    public boolean isAll() {
        return !exclusive && names.isEmpty();
    }

    /** These links where a shape or a group has another name. */
    public ShapeLinks rename(String oldName, String newName) {
        return !names.contains(oldName) ? this
                : new ShapeLinks(exclusive, names.stream().map(n -> n.equals(oldName) ? newName : n).toList());
    }

    /** These links without names that are not known. */
    public ShapeLinks retain(Predicate<String> exists) {
        return names.stream().allMatch(exists) ? this : new ShapeLinks(exclusive, names.stream().filter(exists).toList());
    }

    /** These links with one name more, the last, or without it. */
    public ShapeLinks with(String name, boolean linked) {
        List<String> newNames = new ArrayList<>(names);
        newNames.remove(name);
        if (linked) {
            newNames.add(name);
        }
        return new ShapeLinks(exclusive, newNames);
    }

    /** For people: {@code all}, {@code none}, {@code only a, b} or {@code all but a, b}. */
    public String format() {
        String list = names.stream().map(Quote::of).collect(Collectors.joining(", "));
        return isAll() ? Messages.tr("all") : equals(NONE) ? Messages.tr("none") : exclusive ? Messages.tr("only {0}", list)
                : Messages.tr("all except {0}", list);
    }
}
