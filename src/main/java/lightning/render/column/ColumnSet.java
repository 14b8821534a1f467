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
    private static final ClassValue<Enum<?>[]> ALL = new ClassValue<>() {
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
    private static <C extends Enum<C>> C[] all(Class<C> kinds) {
        return (C[]) ALL.get(kinds);
    }

    /**
     * Columns of all kinds.
     *
     * @param columns an array for each kind, in the order of the kinds; null where there is none
     */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> of(Class<C> kinds, Object... columns) {
        C[] all = all(kinds);
        if (columns.length != all.length) {
            throw new IllegalArgumentException("there are " + all.length + " kinds of columns, and not " + columns.length);
        }
        return new ColumnSet<>(all, columns);
    }

    /** New columns of some kinds for {@code rows} rows, all 0. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> room(Class<C> kinds, Set<C> which, int rows) {
        C[] all = all(kinds);
        ColumnSet<C> set = new ColumnSet<>(all, new Object[all.length]);
        for (C kind : which) {
            set.columns[kind.ordinal()] = kind.element().column(rows);
        }
        return set;
    }

    /** These, and all that others have in place of their own. */
    public ColumnSet<C> with(ColumnSet<C> others) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        for (C kind : kinds) {
            if (others.has(kind)) {
                set.columns[kind.ordinal()] = others.get(kind);
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
    public ColumnSet<C> without(Set<C> which) {
        ColumnSet<C> set = new ColumnSet<>(kinds, columns.clone());
        for (C kind : which) {
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
    public ColumnSet<C> withUniform(Set<C> which, int count) {
        ColumnSet<C> set = this;
        for (C kind : which) {
            float[] own = (float[]) get(kind);
            float[] shared = UniformColumns.shared(own, count);
            set = shared == own ? set : set.with(kind, shared);
        }
        return set;
    }

    /** These over {@code count} rows in arrays of their own, but for those that are shared. */
    public ColumnSet<C> copied(int count) {
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

    /** The bytes of all arrays that do not stand under the same kind in {@code before} too. */
    public long newBytes(ColumnSet<C> before) {
        long bytes = 0;
        for (C kind : kinds) {
            bytes += get(kind) == before.get(kind) ? 0 : bytes(kind);
        }
        return bytes;
    }

    /** Copies {@code count} rows, from row {@code from} of other columns of these kinds, to row {@code at}, as far as both have them. */
    public void copy(ColumnSet<C> others, int from, int at, int count) {
        for (C kind : kinds) {
            if (has(kind) && others.has(kind)) {
                System.arraycopy(others.get(kind), from, get(kind), at, count);
            }
        }
    }
}
