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
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import com.tngtech.archunit.library.GeneralCodingRules;
import java.io.FileInputStream;
import java.io.FileReader;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.base.text.UserFacingException;

/**
 * Rules of the package architecture: for each package the packages that it may import. Rows are in order of dependency, so imports go only
 * downwards. Every package needs a row.
 */
final class ArchitectureRules {
    /** Groups from the bottom up: a package imports from its own group and from those before it. */
    private static final List<String> GROUPS = List.of("base", "scene", "render", "format", "shot", "editor", "serve", "bench", "cli");

    /** Packages from the bottom up. */
    private static final List<Layer> LAYERS = List.of(
            row("base.text", ""),
            row("base.math", ""),
            row("base.work", ""),
            row("base.file", "base.text"),
            row("scene.value", "base.text base.math"),
            row("scene.asset", "base.math scene.value"),
            row("scene.attribute", "base.text base.math scene.value scene.asset"),
            row("scene.node", "base.text base.math scene.value scene.attribute"),
            row("scene.light", "base.text base.math scene.value scene.asset scene.attribute scene.node"),
            row("scene.material", "base.text base.math scene.value scene.asset scene.attribute scene.light"),
            row("scene", "base.text base.math scene.value scene.asset scene.attribute scene.node scene.light scene.material"),
            row("scene.paper", "base.text base.math scene.value scene.node scene.light scene.material scene"),
            row("scene.shot", "base.text base.math scene.value scene.attribute scene.node scene.light scene"),
            row("scene.effects", "base.text base.math scene.value scene.asset scene.node scene.light scene.material scene"),
            row("render.column", ""),
            row("render.image.aces", "base.math"),
            row("render.image", "base.text base.math render.image.aces"),
            row("render.trace.solid", "scene.node"),
            row("render.trace.mesh", "scene.node render.trace.solid"),
            row("render.trace.primitive",
                    "base.math scene.value scene.asset scene.node scene.material scene render.trace.solid render.trace.mesh"),
            row("render.trace.tree", "base.math render.trace.solid render.trace.mesh render.trace.primitive"),
            row("render.trace",
                    "base.math scene.value scene.asset scene.node scene.material scene render.column render.trace.solid"
                            + " render.trace.mesh render.trace.primitive render.trace.tree"),
            row("render.gather",
                    "base.text base.math base.work scene.asset scene.light scene.material scene render.column render.image"
                            + " render.trace.tree render.trace"),
            row("render.shading",
                    "base.math base.work scene.value scene.asset scene.light scene.material scene scene.effects"
                            + " render.trace.primitive render.trace.tree render.trace render.gather"),
            row("render.shading.explanation",
                    "base.math scene.value scene.light scene.material scene render.trace.tree render.trace render.gather"
                            + " render.shading"),
            row("render.shading.layer",
                    "base.math scene.value scene.light scene.material scene.effects render.column render.trace.primitive"
                            + " render.trace.tree render.trace render.shading"),
            row("render.shading.composition",
                    "base.math scene.material scene scene.effects render.image render.trace render.gather render.shading"
                            + " render.shading.layer"),
            row("render.shading.reference",
                    "base.math scene.value scene.node scene.light scene.material scene render.image render.trace.tree"
                            + " render.trace render.gather render.shading render.shading.layer"),
            row("render.engine", "render.trace render.shading"),
            row("render.engine.scalar",
                    "base.math scene.value scene.light scene.material render.trace.primitive render.trace.tree render.trace"
                            + " render.shading render.shading.layer render.engine"),
            row("render.engine.lanes",
                    "base.math scene.value scene.node scene.light scene.material render.trace.solid render.trace.mesh"
                            + " render.trace.primitive render.trace.tree render.trace render.shading render.shading.layer render.engine"),
            row("render.engine.choice", "render.engine render.engine.scalar render.engine.lanes"),
            row("render.fulltrace",
                    "base.work scene scene.effects render.image render.trace render.gather render.shading render.shading.layer"
                            + " render.shading.composition render.engine render.engine.choice"),
            row("render.warmup",
                    "base.work scene.light scene.material scene render.image render.trace render.engine render.engine.choice"
                            + " render.fulltrace"),
            row("render.cache",
                    "scene.light scene render.column render.image render.trace render.gather render.shading render.shading.layer"
                            + " render.shading.composition"),
            row("render.relight.plan",
                    "base.text base.math scene.value scene.light scene.material scene render.image render.trace render.gather"
                            + " render.shading render.shading.layer render.shading.composition render.cache"),
            row("render.relight.paper",
                    "base.math scene.light scene render.column render.image render.trace render.shading render.shading.layer"
                            + " render.cache render.relight.plan"),
            row("render.relight.tile",
                    "base.work scene.light scene scene.effects render.column render.image render.trace.tree render.trace"
                            + " render.gather render.shading render.shading.layer render.shading.composition render.engine"
                            + " render.engine.choice render.cache render.relight.plan render.relight.paper"),
            row("render.relight",
                    "base.math base.work scene.value scene.light scene.material scene scene.effects render.image render.trace"
                            + " render.gather render.shading render.shading.layer render.shading.composition render.engine render.cache"
                            + " render.relight.plan render.relight.tile"),
            row("render.measure",
                    "base.text base.math base.work scene.value scene.light scene.material scene scene.effects render.image"
                            + " render.trace render.gather render.shading render.shading.layer render.shading.composition render.engine"
                            + " render.engine.choice render.fulltrace render.cache render.relight.plan render.relight.tile render.relight"),
            row("format.mesh", "base.text base.work base.file scene.node"),
            row("format.mesh.subdivision", "format.mesh"),
            row("format.mesh.ply", "base.text base.math scene.node format.mesh"),
            row("format.mesh.obj", "base.text base.math scene.node format.mesh"),
            row("format.gltf", "base.text base.math base.work base.file scene.node format.mesh"),
            row("format.nff", "base.text base.math scene.node format.mesh"),
            row("format", "base.work scene.node format.mesh format.mesh.ply format.mesh.obj format.gltf format.nff"),
            row("format.ies", "base.text base.file scene.value format.mesh"),
            row("format.hdr", "base.text base.file scene.value scene.asset format.mesh"),
            row("format.exr", "base.text base.math"),
            row("format.jen.asset",
                    "base.text base.math base.work base.file scene.value scene.asset scene.node scene format.mesh format"
                            + " format.ies format.hdr format.exr"),
            row("format.jen",
                    "base.text base.math base.file scene.value scene.asset scene.attribute scene.node scene.light scene.material"
                            + " scene scene.shot format format.jen.asset"),
            row("format.image", "base.text base.work base.file render.image format.exr"),
            row("format.matte", "scene.node scene format.exr"),
            row("format.json",
                    "base.math scene.node scene.light scene.material scene render.image render.trace render.gather render.shading"
                            + " render.shading.explanation render.relight"),
            row("format.layer",
                    "base.math base.work base.file scene.value scene.attribute scene.node scene.light scene.material scene"
                            + " scene.effects render.image render.trace render.gather render.shading render.shading.layer"
                            + " render.shading.composition render.engine render.cache format.exr format.matte"),
            row("format.pov",
                    "base.math base.file scene.value scene.asset scene.node scene.light scene.material scene render.image"
                            + " format.image"),
            row("format.usd", "base.text base.math base.work base.file scene.node format.mesh format.mesh.subdivision format.gltf"),
            row("format.exchange.assembly",
                    "base.text base.math base.file scene.value scene.asset scene.attribute scene.node scene.light scene.material"
                            + " scene scene.shot format.mesh format.jen.asset format.jen"),
            row("format.exchange.json",
                    "base.text base.math scene.value scene.asset scene.attribute scene.node scene.light scene.material scene"
                            + " scene.shot format.mesh format.jen.asset format.exchange.assembly"),
            row("format.exchange.usd",
                    "base.text base.math base.work base.file scene.value scene.asset scene.attribute scene.node scene.light"
                            + " scene.material scene scene.shot render.image format.mesh format.gltf format.ies format.exr format.jen.asset"
                            + " format.image format.usd format.exchange.assembly format.exchange.json"),
            row("format.exchange",
                    "base.math base.work base.file scene.value scene.asset scene.node scene.light scene.material scene scene.shot"
                            + " render.image render.trace render.engine render.engine.choice render.fulltrace format.mesh format.mesh.ply"
                            + " format.mesh.obj format.gltf format.nff format format.jen.asset format.usd format.exchange.assembly"
                            + " format.exchange.json format.exchange.usd"),
            row("shot",
                    "base.text base.work base.file scene scene.shot render.column render.image render.trace render.shading"
                            + " render.cache render.relight.plan render.relight.tile render.relight"),
            row("shot.cluster.wire", "base.text base.file"),
            row("shot.cluster",
                    "base.text base.work base.file scene scene.shot render.image render.relight format.mesh format.jen.asset"
                            + " format.jen shot shot.cluster.wire"),
            row("shot.movie",
                    "base.text base.work base.file scene render.image render.warmup render.cache render.relight.tile"
                            + " render.relight"),
            row("editor.loop",
                    "base.text base.work scene.value scene.light scene scene.effects render.image render.trace render.shading"
                            + " render.engine.choice render.fulltrace render.warmup render.cache render.relight.plan render.relight.tile"
                            + " render.relight render.measure"),
            row("editor.document.manipulation", "base.text base.math scene.value scene.node scene.light scene render.trace"),
            row("editor.document",
                    "base.text base.math base.work base.file scene.value scene.asset scene.attribute scene.node scene.light"
                            + " scene.material scene scene.shot render.image render.shading render.cache render.relight.tile"
                            + " format.jen.asset format.jen editor.loop editor.document.manipulation"),
            row("editor.document.cue",
                    "base.text base.math base.file scene.value scene.attribute scene.light scene render.image format.jen"
                            + " format.image editor.document"),
            row("editor.document.motion",
                    "base.text base.math base.work base.file scene.value scene.light scene scene.shot render.image render.warmup"
                            + " render.relight.plan render.relight.tile render.relight format.image"),
            row("editor.window.widget", "base.text base.math scene.value scene.light scene render.image editor.document"),
            row("editor.window.model",
                    "base.text base.work base.file scene.value scene.node scene.light scene.material scene scene.shot"
                            + " scene.effects render.image render.shading render.relight.plan render.relight.tile render.relight"
                            + " render.measure format.jen.asset editor.loop editor.document.manipulation editor.document"),
            row("editor.window.command",
                    "base.text base.work base.file scene.value scene.node scene.light scene.material scene scene.shot"
                            + " render.image render.engine render.cache render.relight.tile render.relight format.exr format.jen.asset"
                            + " format.jen format.image format.layer format.exchange.assembly format.exchange editor.loop editor.document"
                            + " editor.document.cue editor.window.widget editor.window.model"),
            row("editor.window.property",
                    "base.text base.math base.file scene.value scene.asset scene.attribute scene.node scene.light scene.material"
                            + " scene scene.shot render.image format.jen.asset format.jen editor.document editor.window.widget"
                            + " editor.window.model editor.window.command"),
            row("editor.window.traced",
                    "base.text base.math base.work scene.value scene.node scene.light scene render.image render.trace"
                            + " render.shading render.shading.explanation render.fulltrace render.relight render.measure editor.loop"
                            + " editor.document.manipulation editor.document editor.window.widget editor.window.model editor.window.command"),
            row("editor.window.preview",
                    "base.text base.math base.work scene.value scene.node scene.light scene scene.effects render.image"
                            + " render.trace render.cache render.relight.plan render.relight.tile render.relight editor.loop"
                            + " editor.document.manipulation editor.document editor.window.widget editor.window.model editor.window.command"),
            row("editor.window.animation",
                    "base.text base.work scene.value scene.light scene scene.shot render.image editor.loop editor.document"
                            + " editor.document.motion editor.window.widget editor.window.model editor.window.command"),
            row("editor.window.timeline",
                    "base.text base.work base.file scene.value scene.attribute scene.light scene scene.shot render.image"
                            + " render.cache render.relight.plan render.relight.tile render.relight format.jen format.image shot"
                            + " shot.cluster shot.movie editor.document editor.window.widget editor.window.model editor.window.command"),
            row("editor.window.dock", "editor.document editor.window.model editor.window.command"),
            row("editor.window.measure",
                    "base.text base.work scene scene.paper scene.effects render.image render.relight.plan render.relight.tile"
                            + " render.relight render.measure editor.loop editor.document editor.window.widget editor.window.model"),
            row("editor.window.mixer",
                    "base.text base.math base.work scene.value scene.light scene render.image render.cache render.relight.tile"
                            + " render.relight editor.loop editor.document editor.window.widget editor.window.model editor.window.command"),
            row("editor.window.contribution",
                    "base.text base.work scene.light scene render.image render.cache render.relight.tile render.relight"
                            + " editor.loop editor.document editor.window.widget editor.window.model"),
            row("editor.window.link",
                    "base.text scene.value scene.light scene editor.document editor.window.widget editor.window.model"
                            + " editor.window.command"),
            row("editor.window.cue",
                    "base.text scene render.image editor.loop editor.document editor.document.cue editor.window.widget"
                            + " editor.window.model editor.window.command"),
            row("editor.window.welcome",
                    "base.text base.file scene.light scene editor.document editor.window.model editor.window.command"),
            row("editor.window",
                    "base.text base.file scene.value scene.node scene.light scene render.image render.shading render.relight.plan"
                            + " render.relight render.measure format.jen format.exchange editor.loop editor.document editor.window.widget"
                            + " editor.window.model editor.window.command editor.window.property editor.window.traced editor.window.preview"
                            + " editor.window.animation editor.window.timeline editor.window.dock editor.window.measure editor.window.mixer"
                            + " editor.window.contribution editor.window.link editor.window.cue editor.window.welcome"),
            row("serve",
                    "base.text base.work base.file scene.light scene.material scene scene.shot render.image render.trace"
                            + " render.shading render.shading.explanation render.engine render.cache render.relight.plan render.relight.tile"
                            + " render.relight format.mesh format.exr format.jen.asset format.jen format.image format.json format.layer"
                            + " format.exchange.assembly format.exchange editor.loop editor.document"),
            row("bench.accuracy",
                    "base.math base.work scene.value scene.light scene scene.paper scene.effects render.image render.trace"
                            + " render.gather render.shading render.engine render.engine.choice render.fulltrace render.cache"
                            + " render.relight.tile render.relight render.measure"),
            row("bench.mesh", "base.file scene.node render.trace.solid render.trace.mesh"),
            row("bench.result",
                    "base.text base.file scene scene.paper scene.effects render.shading render.relight.plan render.relight"
                            + " render.measure format.pov bench.accuracy"),
            row("bench",
                    "base.math base.work base.file scene.value scene.node scene.light scene.material scene scene.paper"
                            + " scene.effects render.image render.trace.mesh render.trace render.shading render.shading.explanation"
                            + " render.engine render.engine.choice render.fulltrace render.cache render.relight.plan render.relight.tile"
                            + " render.relight render.measure format.jen format.image format.pov bench.accuracy bench.mesh bench.result"),
            row("bench.report",
                    "base.file render.image render.relight.plan render.measure format.image bench.accuracy bench.result"),
            row("cli.report", "render.shading format.json"),
            row("cli.output",
                    "base.text base.work base.file scene render.image render.shading render.relight.plan render.relight"
                            + " render.measure format.jen format.image format.layer shot shot.movie bench.accuracy bench.result cli.report"),
            row("cli.option",
                    "base.text base.work scene.value scene scene.shot render.image render.engine render.cache render.relight.plan"
                            + " render.relight format.exr format.jen format.image format.layer shot.cluster cli.output"),
            row("cli",
                    "base.text base.math base.work base.file scene.asset scene.node scene.light scene.material scene scene.paper"
                            + " scene.shot scene.effects render.image render.trace render.gather render.shading render.shading.explanation"
                            + " render.shading.layer render.engine render.engine.choice render.fulltrace render.warmup render.cache"
                            + " render.relight.plan render.relight.tile render.relight render.measure format format.hdr format.jen.asset"
                            + " format.jen format.image format.json format.layer format.pov format.exchange.assembly format.exchange shot"
                            + " shot.cluster shot.movie serve bench.accuracy bench.result bench bench.report cli.report cli.output"
                            + " cli.option"),
            row("", "format.jen editor.window cli"));

    /** @param dependencies packages that it may import, in addition to itself */
    private record Layer(String name, Set<String> dependencies) {
        /** Classes of the root package start the program and may use all packages. */
        String packageName() {
            return name.isEmpty() ? "lightning" : "lightning." + name;
        }
    }

    private static Layer row(String name, String known) {
        return new Layer(name, known.isEmpty() ? Set.of() : Set.of(known.split(" ")));
    }

    /** The reference tracer: the oracle of every equality test, kept simple enough to trust. */
    private static final String REFERENCE =
            "lightning\\.render\\.shading\\.reference\\.Reference(Tracer|Indirect|GatherPoints|GatherRay|PointLight)(\\$.*)?";

    private ArchitectureRules() {}

    /** Returns a rule for each row: it imports only the listed packages. */
    static ArchRule layersDependOnlyOnLowerLayers() {
        CompositeArchRule all = CompositeArchRule.of(everyClassHasALayer());
        for (Layer row : LAYERS) {
            String[] unknown = LAYERS.stream().filter(other -> other != row && !row.dependencies().contains(other.name()))
                    .map(Layer::packageName).toArray(String[]::new);
            all = all.and(noClasses().that().resideInAPackage(row.packageName())
                    .should().dependOnClassesThat(resideInAnyPackage(unknown))
                    .as(row.packageName() + " depends only on rows above it")
                    .allowEmptyShould(true));
        }
        return all;
    }

    /** Returns rows that precede one of a lower group, or belong to no group; must be empty. */
    static List<String> layersOutOfOrder() {
        List<String> wrong = new ArrayList<>();
        int highest = 0;
        for (Layer row : LAYERS.subList(0, LAYERS.size() - 1)) {
            int group = GROUPS.indexOf(row.name().split("\\.")[0]);
            if (group < highest) {
                wrong.add(row.name());
            }
            highest = Math.max(highest, group);
        }
        return wrong;
    }

    /** Returns rows that depend on a later or missing row; must be empty. */
    static List<String> layersWithForwardDependency() {
        List<String> wrong = new ArrayList<>();
        Set<String> before = new HashSet<>();
        for (Layer row : LAYERS) {
            row.dependencies().stream().filter(known -> !before.contains(known)).forEach(known -> wrong.add(row.name() + " → " + known));
            before.add(row.name());
        }
        return wrong;
    }

    private static ArchRule everyClassHasALayer() {
        return classes().that(not(nameMatching("module-info")))
                .should().resideInAnyPackage(LAYERS.stream().map(Layer::packageName).toArray(String[]::new))
                .as("every class is in a package that has a row in this test")
                .allowEmptyShould(true);
    }

    static ArchRule onlyEditorUsesJavaFx() {
        return noClasses().that(not(resideInAPackage(packageOf("editor.window"))))
                .should().dependOnClassesThat().resideInAnyPackage("javafx..", "com.sun.javafx..")
                .as("only lightning.editor.window sees JavaFX")
                .allowEmptyShould(true);
    }

    /** Menu items are created only from commands. Submenus and separators have no action. */
    static ArchRule onlyCommandItemsCreateMenuItems() {
        return noClasses().that(not(nameMatching("lightning\\.editor\\.window\\.command\\.CommandMenuItems")))
                .should().callConstructorWhere(target(owner(assignableTo("javafx.scene.control.MenuItem")
                        .and(not(nameMatching("javafx\\.scene\\.control\\.(Menu|SeparatorMenuItem)").forSubtype())))))
                .as("only CommandMenuItems creates menu items")
                .allowEmptyShould(true);
    }

    static ArchRule onlyCommandsPrint() {
        return noClasses().that(not(resideInAnyPackage(packageOf("cli"), packageOf("bench")).or(resideInAPackage("lightning"))))
                .should(GeneralCodingRules.ACCESS_STANDARD_STREAMS)
                .as("only lightning.cli, lightning.bench and lightning.Main print")
                .allowEmptyShould(true);
    }

    /**
     * Opening a pipe may block forever, and some devices never end, so one class opens all files named by users or their files. The other
     * listed classes read files that the program wrote, or found to be regular.
     */
    static ArchRule userFilesAreOpenedByOneClass() {
        DescribedPredicate<JavaClass> own =
                resideInAnyPackage(packageOf("base.file"), packageOf("shot.cluster"), packageOf("bench"), packageOf("format.pov"))
                        .or(nameMatching(".*\\.(RecoveryFolder|OpenSceneRegistry|SceneSaver|Preferences)"));
        return CompositeArchRule
                .of(noClasses().that(not(own))
                        .should().callMethodWhere(target(owner(assignableTo(Files.class)))
                                .and(target(nameMatching("newInputStream|newBufferedReader|readAll.*|readString|lines|copy|mismatch"))))
                        .as("only RegularFile opens files named by users")
                        .allowEmptyShould(true))
                .and(noClasses().that(not(own))
                        .should().callConstructorWhere(target(owner(assignableTo(FileInputStream.class)
                                .or(assignableTo(RandomAccessFile.class)).or(assignableTo(FileReader.class)))))
                        .as("only RegularFile opens files named by users")
                        .allowEmptyShould(true));
    }

    /** Checked exceptions reach the user and must not look like internal errors. */
    static ArchRule checkedExceptionsAreUserFacing() {
        return classes()
                .that(assignableTo(Exception.class).and(not(assignableTo(RuntimeException.class)))
                        .and(not(assignableTo(IOException.class))))
                .should().beAssignableTo(UserFacingException.class)
                .as("checked exceptions are user-facing")
                .allowEmptyShould(true);
    }

    /**
     * The oracle stays independent of the tested code. Through its helpers it uses no kernel and no cache; it never uses the BVH, which a
     * scene's geometry holds for the kernels.
     */
    static ArchRule referenceTracerIsIndependent() {
        return CompositeArchRule
                .of(noClasses().that(nameMatching(REFERENCE))
                        .should().transitivelyDependOnClassesThat(resideInAnyPackage(packageOf("render.cache"),
                                packageOf("render.relight"), packageOf("render.engine")).or(kernel(".*(Packet|Lanes).*")))
                        .as("the reference tracer uses no cache, relighting, engine or fast kernel")
                        .allowEmptyShould(true))
                .and(noClasses().that(nameMatching(REFERENCE))
                        .should().dependOnClassesThat(kernel(".*Bvh.*"))
                        .as("the reference tracer tests every shape, without a BVH")
                        .allowEmptyShould(true));
    }

    private static DescribedPredicate<JavaClass> kernel(String name) {
        return resideInAPackage(packageOf("render.trace")).and(nameMatching(name));
    }

    private static String packageOf(String row) {
        return "lightning." + row + "..";
    }
}
