package lightning.render.column;

import java.util.Collection;

/** Kind of column that rows may have: a constant of the closed set of their class. */
public interface ColumnKind {
    /** Returns the type of its elements. */
    ElementType element();

    /** Returns its index in the set. */
    int ordinal();

    /** Returns the bytes per row in columns of some kinds. */
    static int bytesPerRow(Collection<? extends ColumnKind> kinds) {
        return kinds.stream().mapToInt(kind -> kind.element().bytes()).sum();
    }
}
