package lightning.render.column;

import java.util.Collection;

/** One of the columns that rows may have: a constant of the closed set that their class states. */
public interface ColumnKind {
    /** What it holds for each row. */
    ElementType element();

    /** Its place in the set. */
    int ordinal();

    /** The bytes of a row in columns of some kinds. */
    static int bytesPerRow(Collection<? extends ColumnKind> kinds) {
        return kinds.stream().mapToInt(kind -> kind.element().bytes()).sum();
    }
}
