package lightning;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.GeneralCodingRules;
import java.io.FileInputStream;
import java.io.FileReader;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.text.Told;

/**
 * Who may know whom: a row for each package, with all that it may import. Nothing is known that is not told here, and no
 * row is told a later one, so that all ways go in one direction. A package without a row is a fault.
 */
final class Architecture {
    private static final String ENGINE =
            "text math column scene effects image trace shading engine engine.scalar engine.lanes engine.choice fulltrace warmup cache work"
                    + " relight.plan relight.tile relight";
    private static final String DOCUMENT = ENGINE + " file jen scene.shot accuracy edit.loop edit";
    private static final String DESK = DOCUMENT + " app.widget app.model app.command";

    /** The rows from the bottom of the program up. */
    private static final List<Row> ROWS = List.of(
            row("text", ""),
            row("math", ""),
            row("work", ""),
            row("column", ""),
            row("file", "text"),
            row("mesh", "text file work"),
            row("mesh.ply", "text math mesh"),
            row("mesh.obj", "text math mesh"),
            row("gltf", "text math file mesh work"),
            row("nff", "text math mesh"),
            row("mesh.file", "mesh mesh.ply mesh.obj gltf nff work"),
            row("scene", "text math mesh"),
            row("scene.shot", "text math scene"),
            row("ies", "text file mesh scene"),
            row("hdr", "text file mesh scene"),
            row("effects", "text math scene"),
            row("jen", "text math file mesh mesh.file scene scene.shot ies hdr work"),
            row("exr", "text"),
            row("image", "text math file exr work"),
            row("trace.solid", "scene"),
            row("trace.mesh", "mesh trace.solid"),
            row("trace.primitive", "math scene trace.solid trace.mesh"),
            row("trace.tree", "math trace.solid trace.mesh trace.primitive"),
            row("trace", "math column mesh scene trace.solid trace.mesh trace.primitive trace.tree"),
            row("shading", "math column scene effects image trace.tree trace trace.mesh trace.primitive"),
            row("engine", "trace shading"),
            row("engine.scalar", "math scene trace.primitive trace.tree trace shading engine"),
            row("engine.lanes", "math scene trace.solid trace.mesh trace.primitive trace.tree trace shading engine engine.scalar"),
            row("engine.choice", "engine engine.scalar engine.lanes"),
            row("fulltrace", "scene effects image trace shading engine engine.choice work"),
            row("warmup", "scene image trace engine engine.choice fulltrace work"),
            row("cache", "column scene image trace shading"),
            row("relight.plan", "text math scene image trace shading cache"),
            row("relight.tile", "scene effects image trace shading engine engine.choice cache work relight.plan"),
            row("relight", "math column scene effects image trace shading engine cache work relight.plan relight.tile"),
            row("shot", "text column scene scene.shot image trace shading engine cache work file relight.plan relight.tile relight"),
            row("cluster.wire", "text"),
            row("cluster", "text scene scene.shot image jen file mesh work relight shot cluster.wire"),
            row("layer", ENGINE + " exr file"),
            row("movie", ENGINE + " file"),
            row("accuracy", ENGINE),
            row("edit.loop", ENGINE + " accuracy"),
            row("edit", ENGINE + " file jen scene.shot accuracy edit.loop"),
            row("edit.cue", "text math file scene jen image edit"),
            row("edit.motion", ENGINE + " file scene.shot edit"),
            row("exchange", "text math file mesh mesh.ply mesh.obj gltf nff mesh.file scene jen image trace fulltrace work"),
            row("app.widget", "text math scene image edit"),
            row("app.model", DOCUMENT),
            row("app.command", DOCUMENT + " exr layer edit.cue exchange app.widget app.model"),
            row("app.property", DESK),
            row("app.traced", DESK),
            row("app.preview", DESK),
            row("app.animation", DESK + " edit.motion"),
            row("app.timeline", DESK + " movie shot cluster"),
            row("app.measure", DESK),
            row("app.mixer", DESK),
            row("app.contribution", DESK),
            row("app.cue", DESK + " edit.cue"),
            row("app", DESK
                    + " exchange movie edit.motion app.property app.traced app.preview app.animation app.timeline app.measure app.mixer app.contribution edit.cue app.cue"),
            row("pov", "math file mesh scene image"),
            row("bench.mesh", "mesh trace.solid trace.mesh"),
            row("bench", ENGINE + " file jen mesh trace.mesh accuracy pov bench.mesh"),
            row("bench.report", ENGINE + " file accuracy bench"),
            row("cli", ENGINE + " file exr jen scene.shot shot hdr layer movie accuracy mesh exchange pov cluster bench bench.report"),
            row("", "app cli"));

    /** @param known the packages that it may import, beside itself */
    private record Row(String name, Set<String> known) {
        /** What starts the program stands above all packages. */
        String packageName() {
            return name.isEmpty() ? "lightning" : "lightning." + name;
        }
    }

    private static Row row(String name, String known) {
        return new Row(name, known.isEmpty() ? Set.of() : Set.of(known.split(" ")));
    }

    /** The class that no reader may have to doubt: the oracle of every equality test. */
    private static final String REFERENCE = "lightning\\.shading\\.ReferenceTracer(\\$.*)?";

    private Architecture() {}

    /** One rule for each row: it knows nothing but the rows that it may know. */
    static ArchRule rowsKnowOnlyRowsAbove() {
        CompositeArchRule all = CompositeArchRule.of(everyClassHasARow());
        for (Row row : ROWS) {
            String[] unknown = ROWS.stream().filter(other -> other != row && !row.known().contains(other.name()))
                    .map(Row::packageName).toArray(String[]::new);
            all = all.and(noClasses().that().resideInAPackage(row.packageName())
                    .should().dependOnClassesThat(resideInAnyPackage(unknown))
                    .as(row.packageName() + " knows only rows above it")
                    .allowEmptyShould(true));
        }
        return all;
    }

    /** The rows that are told one that comes after them, or that there is not: none. */
    static List<String> rowsToldALaterOne() {
        List<String> wrong = new ArrayList<>();
        Set<String> before = new HashSet<>();
        for (Row row : ROWS) {
            row.known().stream().filter(known -> !before.contains(known)).forEach(known -> wrong.add(row.name() + " → " + known));
            before.add(row.name());
        }
        return wrong;
    }

    private static ArchRule everyClassHasARow() {
        return classes().that(not(nameMatching("module-info")))
                .should().resideInAnyPackage(ROWS.stream().map(Row::packageName).toArray(String[]::new))
                .as("every class lives in a package that has a row in this test")
                .allowEmptyShould(true);
    }

    /** A word means one thing: no class has the name of one in another package. */
    static ArchRule classesHaveNamesOfTheirOwn() {
        return classes().that().areTopLevelClasses().and(not(nameMatching(".*package-info"))).should(haveNamesOfTheirOwn())
                .as("no two classes have one name");
    }

    private static ArchCondition<JavaClass> haveNamesOfTheirOwn() {
        return new ArchCondition<>("have names of their own") {
            private final Map<String, JavaClass> known = new HashMap<>();

            @Override
            public void check(JavaClass next, ConditionEvents events) {
                JavaClass other = known.putIfAbsent(next.getSimpleName(), next);
                if (other != null) {
                    events.add(SimpleConditionEvent.violated(next, next.getName() + " has the name of " + other.getName()));
                }
            }
        };
    }

    static ArchRule onlyAppSeesJavaFx() {
        return noClasses().that(not(resideInAPackage(packageOf("app"))))
                .should().dependOnClassesThat().resideInAnyPackage("javafx..", "com.sun.javafx..")
                .as("only lightning.app sees JavaFX")
                .allowEmptyShould(true);
    }

    /** Whatever a menu offers is made of a command. A menu within a menu and a line between items do nothing. */
    static ArchRule onlyCommandItemsMakeItems() {
        return noClasses().that(not(nameMatching("lightning\\.app\\.command\\.CommandItems")))
                .should().callConstructorWhere(target(owner(assignableTo("javafx.scene.control.MenuItem")
                        .and(not(nameMatching("javafx\\.scene\\.control\\.(Menu|SeparatorMenuItem)").forSubtype())))))
                .as("only CommandItems makes items of menus")
                .allowEmptyShould(true);
    }

    static ArchRule onlyCommandsPrint() {
        return noClasses().that(not(resideInAnyPackage(packageOf("cli"), packageOf("bench")).or(resideInAPackage("lightning"))))
                .should(GeneralCodingRules.ACCESS_STANDARD_STREAMS)
                .as("only lightning.cli, lightning.bench and lightning.Main print")
                .allowEmptyShould(true);
    }

    /**
     * A pipe that is opened waits for ever, and some devices never end: what users and their files name is opened where that is checked. The
     * other rows read what the program itself has written, or found to be a file.
     */
    static ArchRule namedFilesAreOpenedInOnePlace() {
        DescribedPredicate<JavaClass> own =
                resideInAnyPackage(packageOf("file"), packageOf("cluster"), packageOf("bench"), packageOf("pov"))
                        .or(nameMatching(".*\\.(Recovery|Presence|SceneSaver|Preferences)"));
        return CompositeArchRule
                .of(noClasses().that(not(own))
                        .should().callMethodWhere(target(owner(assignableTo(Files.class)))
                                .and(target(nameMatching("newInputStream|newBufferedReader|readAll.*|readString|lines|copy|mismatch"))))
                        .as("only OrdinaryFile opens files that users name")
                        .allowEmptyShould(true))
                .and(noClasses().that(not(own))
                        .should().callConstructorWhere(target(owner(assignableTo(FileInputStream.class)
                                .or(assignableTo(RandomAccessFile.class)).or(assignableTo(FileReader.class)))))
                        .as("only OrdinaryFile opens files that users name")
                        .allowEmptyShould(true));
    }

    /** What is thrown to be caught by others reaches a user somewhere, and must not be taken there for a fault of the program. */
    static ArchRule checkedExceptionsAreTold() {
        return classes()
                .that(assignableTo(Exception.class).and(not(assignableTo(RuntimeException.class)))
                        .and(not(assignableTo(IOException.class))))
                .should().beAssignableTo(Told.class)
                .as("checked exceptions are for users to read")
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
                                packageOf("relight"), packageOf("engine")).or(kernel(".*(Packet|Lanes).*")))
                        .as("the reference tracer knows neither cache nor relight nor engine nor fast kernels")
                        .allowEmptyShould(true))
                .and(noClasses().that(nameMatching(REFERENCE))
                        .should().dependOnClassesThat(kernel(".*Bvh.*"))
                        .as("the reference tracer asks every shape, and no tree of boxes")
                        .allowEmptyShould(true));
    }

    private static DescribedPredicate<JavaClass> kernel(String name) {
        return resideInAPackage(packageOf("trace")).and(nameMatching(name));
    }

    private static String packageOf(String row) {
        return "lightning." + row + "..";
    }
}
