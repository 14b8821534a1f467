package lightning.render.column;

import java.util.Set;

/**
 * The columns that some rows have, each an array under its kind. Which array stands under which kind never changes. Hot code
 * reads the arrays as fields of the rows, which are set once, from here.
 *
 * @param <C> the kinds that these rows may have
 */
public final class ColumnSet<C extends Enum<C> & ColumnKind> {
    /** Of each type all its constants, by ordinal: millions of sets share them. */
    private static final ClassValue<Enum<?>[]> KIND_CACHE = new ClassValue<>() {
        @Override
        protected Enum<?>[] computeValue(Class<?> type) {
            return (Enum<?>[]) type.getEnumConstants();
        }
    };

    /** All that there are, by ordinal. */
    private final C[] kinds;
    /** By the kind's ordinal; null where the rows have no such column. */
    private final Object[] columns;

    private ColumnSet(C[] kinds, Object[] columns) {
        this.kinds = kinds;
        this.columns = columns;
    }

    /** The constants of a type are of that type. */
    @SuppressWarnings("unchecked")
    private static <C extends Enum<C>> C[] kindsOf(Class<C> kinds) {
        return (C[]) KIND_CACHE.get(kinds);
    }

    /**
     * Columns of all kinds.
     *
     * @param columns an array for each kind, in the order of the kinds; null where there is none
     */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> of(Class<C> kinds, Object... columns) {
        C[] allKinds = kindsOf(kinds);
        if (columns.length != allKinds.length) {
            throw new IllegalArgumentException("there are " + allKinds.length + " kinds of columns, and not " + columns.length);
        }
        return new ColumnSet<>(allKinds, columns);
    }

    /** New columns of some kinds for {@code rows} rows, all 0. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> allocate(Class<C> kinds, Set<C> selected, int rows) {
        C[] allKinds = kindsOf(kinds);
        ColumnSet<C> set = new ColumnSet<>(allKinds, new Object[allKinds.length]);
        for (C kind : selected) {
            set.columns[kind.ordinal()] = kind.element().column(rows);
        }
        return set;
    }

    /** These, and all that others have in place of their own. */
    public ColumnSet<C> with(ColumnSet<C> source) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        for (C kind : kinds) {
            if (source.has(kind)) {
                set.columns[kind.ordinal()] = source.get(kind);
            }
        }
        return set;
    }

    /** These with another array under a kind, or with none where it is null. */
    public ColumnSet<C> with(C kind, Object column) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        set.columns[kind.ordinal()] = column;
        return set;
    }

    /** These without some kinds. */
    public ColumnSet<C> without(Set<C> removed) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        for (C kind : removed) {
            set.columns[kind.ordinal()] = null;
        }
        return set;
    }

    /** All kinds that there are, in their order. */
    C[] kinds() {
        return kinds;
    }

    /** The array under a kind, of the type that its element tells; null where there is none. */
    public Object get(C kind) {
        return columns[kind.ordinal()];
    }

    public boolean has(C kind) {
        return get(kind) != null;
    }

    /** These, with columns of some kinds of floats shared as far as {@code count} rows have one value there. */
    public ColumnSet<C> withUniform(Set<C> candidates, int count) {
        ColumnSet<C> set = this;
        for (C kind : candidates) {
            float[] column = (float[]) get(kind);
            float[] shared = UniformColumns.share(column, count);
            set = shared == column ? set : set.with(kind, shared);
        }
        return set;
    }

    /** These over {@code count} rows in arrays of their own, but for those that are shared. */
    public ColumnSet<C> deepCopy(int count) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        for (C kind : kinds) {
            if (has(kind)) {
                set.columns[kind.ordinal()] = kind.element().copy(get(kind), count);
            }
        }
        return set;
    }

    /** The bytes of a kind's array, its header left out; 0 where there is none, or one that is shared. */
    public long bytes(C kind) {
        return has(kind) ? kind.element().bytes(get(kind)) : 0;
    }

    /** The bytes of all arrays, headers left out. */
    public long bytes() {
        long bytes = 0;
        for (C kind : kinds) {
            bytes += bytes(kind);
        }
        return bytes;
    }

    /** The bytes of all arrays that do not stand under the same kind in {@code previous} too. */
    public long newBytes(ColumnSet<C> previous) {
        long bytes = 0;
        for (C kind : kinds) {
            bytes += get(kind) == previous.get(kind) ? 0 : bytes(kind);
        }
        return bytes;
    }

    /** Copies {@code count} rows, from row {@code from} of other columns of these kinds, to row {@code at}, as far as both have them. */
    public void copy(ColumnSet<C> source, int from, int at, int count) {
        for (C kind : kinds) {
            if (has(kind) && source.has(kind)) {
                System.arraycopy(source.get(kind), from, get(kind), at, count);
            }
        }
    }
}
