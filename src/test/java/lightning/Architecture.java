package lightning;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import com.tngtech.archunit.library.GeneralCodingRules;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Who may know whom. The packages stand in rows, and a row imports only rows above it; some rows
 * are held to fewer. The rules hold for packages that do not exist yet, so a new class is born
 * under them.
 */
final class Architecture {
    /** The rows from the bottom of the program up. */
    private static final List<String> ROWS = List.of("text", "math", "file", "scene", "effects", "jen", "image", "trace", "shading",
            "cache", "relight", "accuracy", "edit", "app", "bench", "cli");

    /** Rows that know less than all the rows above them, with the little that they know. */
    private static final Map<String, Set<String>> NARROWED = Map.of(
            "image", Set.of("text", "math", "file"),
            "effects", Set.of("text", "math", "scene"),
            "jen", Set.of("text", "math", "file", "scene"),
            "bench", allBut("app"),
            "cli", allBut("app"));

    /** The class that no reader may have to doubt: the oracle of every equality test. */
    private static final String REFERENCE = "lightning\\.shading\\.ReferenceTracer(\\$.*)?";

    private Architecture() {}

    /** One rule for each row: it knows nothing but the rows that it may know. */
    static ArchRule rowsKnowOnlyRowsAbove() {
        CompositeArchRule all = CompositeArchRule.of(everyClassHasARow());
        for (var row : forbidden().entrySet()) {
            all = all.and(noClasses().that().resideInAPackage(packageOf(row.getKey()))
                    .should().dependOnClassesThat(resideInAnyPackage(row.getValue()).or(mainClass()))
                    .as("lightning." + row.getKey() + " knows only rows above it")
                    .allowEmptyShould(true));
        }
        return all;
    }

    private static ArchRule everyClassHasARow() {
        return classes().that(not(mainClass()).and(not(nameMatching("module-info"))))
                .should().resideInAnyPackage(ROWS.stream().map(Architecture::packageOf).toArray(String[]::new))
                .as("every class but lightning.Main lives in a package that has a row in this test")
                .allowEmptyShould(true);
    }

    static ArchRule onlyAppSeesJavaFx() {
        return noClasses().that(not(resideInAPackage(packageOf("app"))))
                .should().dependOnClassesThat().resideInAnyPackage("javafx..", "com.sun.javafx..")
                .as("only lightning.app sees JavaFX")
                .allowEmptyShould(true);
    }

    static ArchRule onlyCommandsPrint() {
        return noClasses().that(not(resideInAnyPackage(packageOf("cli"), packageOf("bench")).or(mainClass())))
                .should(GeneralCodingRules.ACCESS_STANDARD_STREAMS)
                .as("only lightning.cli, lightning.bench and lightning.Main print")
                .allowEmptyShould(true);
    }

    /**
     * The oracle stays independent of what it judges. Through its helpers it reaches no kernel and no
     * cache; the tree, which the geometry of a scene keeps ready for the kernels, it never names itself.
     */
    static ArchRule referenceTracerKnowsNoFastCode() {
        return CompositeArchRule
                .of(noClasses().that(nameMatching(REFERENCE))
                        .should().transitivelyDependOnClassesThat(resideInAnyPackage(packageOf("cache"),
                                packageOf("relight")).or(kernel(".*(Packet|Lanes).*")))
                        .as("the reference tracer knows neither cache nor relight nor fast kernels")
                        .allowEmptyShould(true))
                .and(noClasses().that(nameMatching(REFERENCE))
                        .should().dependOnClassesThat(kernel(".*Bvh.*"))
                        .as("the reference tracer asks every shape, and no tree of boxes")
                        .allowEmptyShould(true));
    }

    private static DescribedPredicate<JavaClass> kernel(String name) {
        return resideInAPackage(packageOf("trace")).and(nameMatching(name));
    }

    private static Map<String, String[]> forbidden() {
        Map<String, String[]> forbidden = new LinkedHashMap<>();
        for (String row : ROWS) {
            Set<String> known = NARROWED.getOrDefault(row, Set.copyOf(ROWS.subList(0, ROWS.indexOf(row))));
            forbidden.put(row, ROWS.stream()
                    .filter(other -> !other.equals(row) && !known.contains(other))
                    .map(Architecture::packageOf)
                    .toArray(String[]::new));
        }
        return forbidden;
    }

    private static Set<String> allBut(String unknown) {
        return Set.copyOf(ROWS.stream().filter(row -> !row.equals(unknown)).toList());
    }

    private static DescribedPredicate<JavaClass> mainClass() {
        return nameMatching("lightning\\.Main(\\$.*)?").forSubtype();
    }

    private static String packageOf(String row) {
        return "lightning." + row + "..";
    }
}
