package lightning.render.column;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Columns of some rows, by kind. Each entry is fixed after construction. Hot code reads the arrays from fields of the rows,
 * which are initialized from here.
 *
 * @param <C> kinds that these rows may have
 */
public final class ColumnSet<C extends Enum<C> & ColumnKind> {
    /** Constants of each kind class by ordinal, shared by millions of sets. */
    private static final ClassValue<Enum<?>[]> KIND_CACHE = new ClassValue<>() {
        @Override
        protected Enum<?>[] computeValue(Class<?> type) {
            return (Enum<?>[]) type.getEnumConstants();
        }
    };

    /** All kinds, by ordinal. */
    private final C[] kinds;
    /** Columns by the kind's ordinal; null for missing ones. Ends with the last existing one, since there are millions of sets. */
    private final @Nullable Object[] columns;

    private ColumnSet(C[] kinds, @Nullable Object[] columns) {
        this.kinds = kinds;
        int length = columns.length;
        while (length > 0 && columns[length - 1] == null) {
            length--;
        }
        this.columns = length == columns.length ? columns : Arrays.copyOf(columns, length);
    }

    /** Returns a copy of the columns with a place for each kind. */
    private @Nullable Object[] copy() {
        return Arrays.copyOf(columns, kinds.length);
    }

    /** The constants of a type are of that type. */
    @SuppressWarnings("unchecked")
    private static <C extends Enum<C>> C[] kindsOf(Class<C> kinds) {
        return (C[]) KIND_CACHE.get(kinds);
    }

    /**
     * Returns a set of columns.
     *
     * @param columns one array for each of the first kinds, in their order; null for missing ones
     */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> of(Class<C> kinds, @Nullable Object... columns) {
        C[] allKinds = kindsOf(kinds);
        if (columns.length > allKinds.length) {
            throw new IllegalArgumentException("expected at most " + allKinds.length + " columns, found " + columns.length);
        }
        return new ColumnSet<>(allKinds, columns);
    }

    /** Allocates columns of some kinds for {@code rows} rows, all 0. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> allocate(Class<C> kinds, Set<C> selected, int rows) {
        C[] allKinds = kindsOf(kinds);
        @Nullable
        Object[] columns = new Object[allKinds.length];
        for (C kind : selected) {
            columns[kind.ordinal()] = kind.element().column(rows);
        }
        return new ColumnSet<>(allKinds, columns);
    }

    /** Returns these columns; columns of {@code source} take precedence. */
    public ColumnSet<C> with(ColumnSet<C> source) {
        @Nullable
        Object[] merged = copy();
        for (C kind : kinds) {
            if (source.has(kind)) {
                merged[kind.ordinal()] = source.get(kind);
            }
        }
        return new ColumnSet<>(kinds, merged);
    }

    /** Returns these columns with another array of a kind, or without it if null. */
    public ColumnSet<C> with(C kind, @Nullable Object column) {
        @Nullable
        Object[] changed = copy();
        changed[kind.ordinal()] = column;
        return new ColumnSet<>(kinds, changed);
    }

    /** Returns these columns without some kinds. */
    public ColumnSet<C> without(Set<C> removed) {
        @Nullable
        Object[] kept = copy();
        for (C kind : removed) {
            kept[kind.ordinal()] = null;
        }
        return new ColumnSet<>(kinds, kept);
    }

    /** Returns all kinds, in order. */
    C[] kinds() {
        return kinds;
    }

    /** Returns the array of a kind, typed by its element type; null if missing. */
    public @Nullable Object find(C kind) {
        int i = kind.ordinal();
        return i < columns.length ? columns[i] : null;
    }

    /** Returns the array of a kind that is not missing. */
    public Object get(C kind) {
        return requireNonNull(find(kind));
    }

    public boolean has(C kind) {
        return find(kind) != null;
    }

    /** Returns these columns; replaces float columns of some kinds by shared ones if {@code count} rows have one value. */
    public ColumnSet<C> withUniform(Set<C> candidates, int count) {
        ColumnSet<C> set = this;
        for (C kind : candidates) {
            if (has(kind)) {
                float[] column = (float[]) get(kind);
                float[] shared = UniformColumns.share(column, count);
                set = shared == column ? set : set.with(kind, shared);
            }
        }
        return set;
    }

    /** Returns copies of these columns for {@code count} rows; shared columns stay shared. */
    public ColumnSet<C> deepCopy(int count) {
        @Nullable
        Object[] copies = copy();
        for (C kind : kinds) {
            if (has(kind)) {
                copies[kind.ordinal()] = kind.element().copy(get(kind), count);
            }
        }
        return new ColumnSet<>(kinds, copies);
    }

    /** Returns the bytes of a kind's array without its header; 0 if it is missing or shared. */
    public long bytes(C kind) {
        return has(kind) ? kind.element().bytes(get(kind)) : 0;
    }

    /** Returns the bytes of all arrays without headers. */
    public long bytes() {
        long bytes = 0;
        for (C kind : kinds) {
            bytes += bytes(kind);
        }
        return bytes;
    }

    /** Returns the bytes of all arrays that {@code previous} does not have for the same kind. */
    public long newBytes(ColumnSet<C> previous) {
        long bytes = 0;
        for (C kind : kinds) {
            bytes += find(kind) == previous.find(kind) ? 0 : bytes(kind);
        }
        return bytes;
    }

    /**
     * Copies {@code count} rows, from row {@code from} of another set of these kinds to row {@code at}; skips columns missing
     * in either set.
     */
    public void copy(ColumnSet<C> source, int from, int at, int count) {
        for (C kind : kinds) {
            if (has(kind) && source.has(kind)) {
                System.arraycopy(source.get(kind), from, get(kind), at, count);
            }
        }
    }
}
