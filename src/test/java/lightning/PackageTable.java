package lightning;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Table of the packages and of the packages that each imports: {@code src/test/architecture/packages.txt}. Rows are in order of dependency, so
 * imports go only upwards in the table. Names have no {@code lightning.} in front; the root package is {@code (root)}.
 *
 * <p>{@link #main} writes the table again, for example after packages were moved. Look at the difference before you commit it: the table says
 * what is meant to be, and a new import may be a mistake.
 */
final class PackageTable {
    private static final Path FILE = Path.of("src/test/architecture/packages.txt");
    private static final String ROOT = "(root)";
    private static final String HEADER = """
            # Packages from the bottom up, each with the packages that it imports. ArchitectureTest fails if a row differs from the sources,
            # and prints the row to paste. After moves of packages, write all rows again and look at the difference:
            # mvn -q test-compile exec:exec@test-main -Dlightning.main=lightning.PackageTable
            """;

    /** Groups from the bottom up: a package imports from its own group and from those before it. */
    static final List<String> GROUPS = List.of("base", "scene", "render", "format", "layer", "shot", "document",
            "review", "serve", "editor", "bench", "cli");

    /** @param imports packages that it imports, besides itself */
    record Row(String name, SortedSet<String> imports) {
        static Row parse(String line) {
            int colon = line.indexOf(':');
            String imports = line.substring(colon + 1).strip();
            return new Row(line.substring(0, colon), imports.isEmpty() ? new TreeSet<>() : new TreeSet<>(List.of(imports.split(" +"))));
        }

        String packageName() {
            return name.equals(ROOT) ? "lightning" : "lightning." + name;
        }

        @Override
        public String toString() {
            return (name + ": " + String.join(" ", imports)).strip();
        }
    }

    private final Map<String, Row> rows = new LinkedHashMap<>();

    PackageTable(List<Row> rows) {
        rows.forEach(row -> this.rows.put(row.name(), row));
    }

    static PackageTable read() {
        try {
            return new PackageTable(
                    Files.readAllLines(FILE).stream().filter(line -> !line.isBlank() && !line.startsWith("#")).map(Row::parse)
                            .toList());
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    List<Row> rows() {
        return List.copyOf(rows.values());
    }

    /** Returns the classes of the program. */
    static JavaClasses program() {
        return new ClassFileImporter().withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPackages("lightning");
    }

    /** Returns all imports between packages, with the classes that make them: the importing package, the imported one, the classes. */
    private static Map<String, Map<String, SortedSet<String>>> imports(JavaClasses classes) {
        Map<String, Map<String, SortedSet<String>>> found = new TreeMap<>();
        for (JavaClass type : classes) {
            if (!isModule(type)) {
                Map<String, SortedSet<String>> imported = found.computeIfAbsent(name(type), _ -> new TreeMap<>());
                for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
                    JavaClass target = dependency.getTargetClass().getBaseComponentType();
                    if (target.getPackageName().startsWith("lightning") && !target.getPackageName().equals(type.getPackageName())) {
                        imported.computeIfAbsent(name(target), _ -> new TreeSet<>())
                                .add(type.getSimpleName() + " → " + target.getSimpleName());
                    }
                }
            }
        }
        return found;
    }

    private static boolean isModule(JavaClass type) {
        return type.getSimpleName().equals("module-info") || !type.getPackageName().startsWith("lightning");
    }

    private static String name(JavaClass type) {
        return type.getPackageName().equals("lightning") ? ROOT : type.getPackageName().substring("lightning.".length());
    }

    /** Returns packages without a row, and imports that no row allows. */
    List<String> violations(JavaClasses classes) {
        List<String> found = new ArrayList<>();
        imports(classes).forEach((name, imported) -> {
            Row actual = new Row(name, new TreeSet<>(imported.keySet()));
            Row row = rows.get(name);
            if (row == null) {
                found.add("package " + name + " has no row; if it should exist, add below the rows of its imports:\n    " + actual);
            } else {
                imported.forEach((other, uses) -> {
                    if (!row.imports().contains(other)) {
                        found.add("package " + name + " imports " + other + ", which its row does not allow ("
                                + uses.stream().limit(3).collect(Collectors.joining(", ")) + "); if it should, the row is\n    " + actual);
                    }
                });
            }
        });
        return found;
    }

    /** Returns rows without a package, and allowed imports that no class uses. */
    List<String> unused(JavaClasses classes) {
        List<String> found = new ArrayList<>();
        Map<String, Map<String, SortedSet<String>>> imports = imports(classes);
        rows.forEach((name, row) -> {
            Map<String, SortedSet<String>> imported = imports.get(name);
            if (imported == null) {
                found.add("package " + name + " is gone; remove its row");
            } else if (!imported.keySet().containsAll(row.imports())) {
                SortedSet<String> unused = new TreeSet<>(row.imports());
                unused.removeAll(imported.keySet());
                found.add("package " + name + " does not import " + String.join(" ", unused) + "; the row is\n    "
                        + new Row(name, new TreeSet<>(imported.keySet())));
            }
        });
        return found;
    }

    /** Returns rows that precede one of a lower group, or belong to no group. */
    List<String> outOfOrder() {
        List<String> wrong = new ArrayList<>();
        int highest = 0;
        for (String name : rows.keySet()) {
            int group = group(name);
            if (group < highest) {
                wrong.add(name);
            }
            highest = Math.max(highest, group);
        }
        return wrong;
    }

    /** Returns the group of a package, from the bottom; the root is the highest, and a package without a group the lowest. */
    private static int group(String name) {
        return name.equals(ROOT) ? GROUPS.size() : GROUPS.indexOf(name.split("\\.")[0]);
    }

    /** Returns imports of a later or missing row. */
    List<String> forwardImports() {
        List<String> wrong = new ArrayList<>();
        Set<String> before = new HashSet<>();
        for (Row row : rows.values()) {
            row.imports().stream().filter(other -> !before.contains(other)).forEach(other -> wrong.add(row.name() + " → " + other));
            before.add(row.name());
        }
        return wrong;
    }

    /** Returns the rows of the program: each below its imports, otherwise in the order of this table. */
    private List<Row> written(JavaClasses classes) {
        List<String> order = new ArrayList<>(rows.keySet());
        List<Row> open =
                new ArrayList<>(imports(classes).entrySet().stream().map(e -> new Row(e.getKey(), new TreeSet<>(e.getValue().keySet())))
                        .sorted(Comparator.comparingInt((Row row) -> group(row.name()))
                                .thenComparingInt(row -> order.contains(row.name()) ? order.indexOf(row.name()) : Integer.MAX_VALUE)
                                .thenComparing(Row::name))
                        .toList());
        List<Row> sorted = new ArrayList<>();
        Set<String> done = new HashSet<>();
        while (!open.isEmpty()) {
            Row next = open.stream().filter(row -> done.containsAll(row.imports())).findFirst()
                    .orElseThrow(() -> new IllegalStateException("packages import each other in a circle:\n" + open));
            open.remove(next);
            sorted.add(next);
            done.add(next.name());
        }
        return sorted;
    }

    public static void main(String... args) throws IOException {
        PackageTable table = Files.exists(FILE) ? read() : new PackageTable(List.of());
        Files.createDirectories(FILE.getParent());
        Files.writeString(FILE, HEADER + "\n" + table.written(program()).stream().map(row -> row + "\n").collect(Collectors.joining()));
    }
}
