package lightning.format.jen;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.UnusableFileException;
import lightning.base.math.Vec3;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetFolders;
import lightning.format.jen.asset.AssetSource;
import lightning.format.jen.asset.EnvironmentFolder;
import lightning.format.jen.asset.MeshFolder;
import lightning.format.jen.asset.NameSuggestion;
import lightning.format.jen.asset.ProfileFolder;
import lightning.format.jen.asset.TextureFolder;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.NamedCamera;
import lightning.scene.OverflowCheck;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.Mesh;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Photometry;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/** Builder of the scene from parsed blocks; reports problems between blocks. */
final class SceneBuilder {
    private final TokenList tokens;
    private final ProblemList problems;
    private final FileNotes notes;
    private final TextureFolder textures;
    private final ProfileFolder profiles;
    private final EnvironmentFolder environments;
    private final MeshFolder meshes;
    private final Map<String, Block> blocksByName = new HashMap<>();
    private final Set<String> materialNames = new LinkedHashSet<>();
    private final Set<String> groupNames = new LinkedHashSet<>();
    /** External banks that lights may reference. */
    private final List<LightGroup> existingGroups;
    /** External shapes that lights may be linked to. */
    private final Stage stage;
    /** Environments of the scene, which count together against the limit of memory. */
    private final Set<EnvironmentMap> environmentMaps = Collections.newSetFromMap(new IdentityHashMap<>());
    private int shapes;

    /**
     * Creates a builder.
     *
     * @param notes receives files that are left out or changed
     * @param files asset loaders
     * @param existingGroups external banks that lights may reference
     * @param stage external shapes that lights may be linked to
     */
    SceneBuilder(TokenList tokens, ProblemList problems, FileNotes notes, AssetFolders files, List<LightGroup> existingGroups,
            Stage stage) {
        this.stage = stage;
        this.existingGroups = existingGroups;
        this.tokens = tokens;
        this.problems = problems;
        this.notes = notes;
        textures = files.textures();
        profiles = files.profiles();
        environments = files.environments();
        meshes = files.meshes();
    }

    /** Returns the scene, or empty if there are problems. */
    Optional<Scene> build(List<Block> blocks) {
        List<Block> otherBlocks = blocks.stream().filter(b -> !BlockTypes.NODE_KEYWORDS.contains(b.type.keyword())).toList();
        Optional<PictureSettings> picture = single(otherBlocks, BlockTypes.PICTURE);
        Optional<Camera> camera = single(otherBlocks, BlockTypes.CAMERA);
        List<NamedCamera> cameras = named(otherBlocks, BlockTypes.NAMED_CAMERA, new HashMap<>(), SceneLimits.MAX_CAMERAS,
                "named cameras");
        Optional<World> world = single(otherBlocks, BlockTypes.WORLD);
        single(otherBlocks, BlockTypes.SHOT);
        List<Material> materials = materials(blocksOfType(otherBlocks, BlockTypes.MATERIAL));
        List<SceneNode> nodes = nodes(nodeBlocks(blocks), 1, 1);
        List<LightGroup> groups = lightGroups(blocksOfType(otherBlocks, BlockTypes.LIGHT_GROUP));
        List<Light> lights = lights(blocksOfType(otherBlocks, BlockTypes.LIGHT));
        List<Dome> domes = named(otherBlocks, BlockTypes.DOME, blocksByName, SceneLimits.MAX_DOMES, "domes");
        if (!problems.isEmpty()) {
            return Optional.empty();
        }
        var stage = new Stage(materials, nodes);
        LightRig rig = LightRig.of(lights, groups);
        try {
            OverflowCheck.of(stage, rig)
                    .ifPresent(overflow -> problem(requireNonNull(blocksByName.get(overflow.light().name())), overflow.message()));
        } catch (RefusalException e) {
            lights.forEach(light -> checkPlace(light, stage, groups));
        }
        return problems.isEmpty() ? Optional.of(new Scene(picture.orElse(PictureSettings.DEFAULT), camera.orElse(Camera.DEFAULT),
                world.orElse(World.DEFAULT).withNamed(domes), stage, rig, cameras)) : Optional.empty();
    }

    static List<Block> nodeBlocks(List<Block> blocks) {
        return blocks.stream().filter(b -> BlockTypes.NODE_KEYWORDS.contains(b.type.keyword())).toList();
    }

    static List<Block> blocksOfType(List<Block> blocks, BlockType<?> type) {
        return blocks.stream().filter(b -> b.type == type).toList();
    }

    private <T> Optional<T> single(List<Block> blocks, BlockType<T> type) {
        List<Block> matching = blocksOfType(blocks, type);
        matching.stream().skip(1).forEach(b -> problem(b, b.title() + " must be written once, found it again"));
        return matching.isEmpty() ? Optional.empty() : buildRecord(matching.getFirst(), type, List.of());
    }

    /**
     * Builds the records of a type.
     *
     * @param names blocks whose names the records must not have; receives theirs
     * @param label for a message about more than the maximum
     */
    private <T> List<T> named(List<Block> blocks, BlockType<T> type, Map<String, Block> names, int max, String label) {
        List<Block> ofType = blocksOfType(blocks, type);
        List<T> records = new ArrayList<>();
        for (Block block : ofType) {
            checkUnique(names, block);
            buildRecord(block, type, List.of()).ifPresent(records::add);
        }
        checkCount(ofType, max, label);
        return records;
    }

    private List<Material> materials(List<Block> blocks) {
        List<Material> materials = new ArrayList<>();
        materialNames.add(Material.DEFAULT.name());
        Map<String, Block> blocksByMaterial = new HashMap<>();
        for (Block block : blocks) {
            checkUnique(blocksByMaterial, block);
            materialNames.add(block.name);
            buildRecord(block, BlockTypes.MATERIAL, List.of()).ifPresent(materials::add);
        }
        checkCount(blocks, SceneLimits.MAX_MATERIALS, "materials");
        return materials;
    }

    private List<LightGroup> lightGroups(List<Block> blocks) {
        List<LightGroup> groups = new ArrayList<>(existingGroups);
        existingGroups.forEach(group -> groupNames.add(group.name()));
        for (Block block : blocks) {
            checkUnique(blocksByName, block);
            groupNames.add(block.name);
            buildRecord(block, BlockTypes.LIGHT_GROUP, List.of()).ifPresent(groups::add);
        }
        checkCount(blocks, SceneLimits.MAX_LIGHT_GROUPS, "banks");
        return groups;
    }

    private List<Light> lights(List<Block> blocks) {
        List<Light> lights = new ArrayList<>();
        for (Block block : blocks) {
            checkUnique(blocksByName, block);
            checkReference(block, "bank", groupNames);
            checkLinks(block, LightAttribute.ILLUMINATES);
            checkLinks(block, LightAttribute.SHADOWED_BY);
            checkGains(block);
            checkShape(block);
            buildRecord(block, BlockTypes.LIGHT, List.of()).ifPresent(lights::add);
        }
        checkCount(blocks, SceneLimits.MAX_LIGHTS, "lights");
        return lights;
    }

    /** Groups may move the shape of a light out of the range of positions. */
    private void checkPlace(Light light, Stage stage, List<LightGroup> groups) {
        try {
            OverflowCheck.of(stage, LightRig.of(List.of(light), groups));
        } catch (RefusalException e) {
            Block block = requireNonNull(blocksByName.get(light.name()));
            problem(block, block.title() + ": " + e.getMessage());
        }
    }

    private void checkCount(List<Block> blocks, int max, String label) {
        if (blocks.size() > max) {
            problem(blocks.get(max), "a scene may have at most " + max + " " + label + ", found " + blocks.size());
        }
    }

    /**
     * Builds the shapes and groups.
     *
     * @param minScale product of the smallest scale factors of the enclosing groups
     * @param maxScale product of the largest scale factors
     */
    private List<SceneNode> nodes(List<Block> blocks, double minScale, double maxScale) {
        List<SceneNode> nodes = new ArrayList<>();
        for (Block block : blocks) {
            checkUnique(blocksByName, block);
            Placement scale = scale(block);
            double combinedMin = minScale * scale.minScale();
            double combinedMax = maxScale * scale.maxScale();
            try {
                SceneLimits.checkCombinedScale(block::title, combinedMin, combinedMax);
            } catch (RefusalException e) {
                problem(block, e.getMessage());
            }
            if (block.type != BlockTypes.GROUP) {
                checkReference(block, "material", materialNames);
                if (++shapes == SceneLimits.MAX_SHAPES + 1) {
                    problem(block, "a scene may have at most " + SceneLimits.MAX_SHAPES + " shapes");
                }
            }
            List<SceneNode> children = nodes(block.children, combinedMin, combinedMax);
            buildRecord(block, block.type, children).ifPresent(n -> nodes.add((SceneNode) n));
        }
        return nodes;
    }

    private static Placement scale(Block block) {
        Block.Entry entry = block.entry("scale");
        return entry == null ? Placement.IDENTITY
                : new Placement(Vec3.ZERO, Vec3.ZERO, new PropertyValues(block::value, AssetSource.NONE).vector("scale"));
    }

    /**
     * Checks a reference by name.
     *
     * @param property property with the name, also used as the noun in messages
     */
    private void checkReference(Block block, String property, Set<String> names) {
        Block.Entry entry = block.entry(property);
        if (entry != null && entry.value() instanceof Value.Name(String name) && !names.contains(name)) {
            problems.add(tokens.start(entry.from()), block.title() + ": there is no " + property + " " + Quote.of(name)
                    + NameSuggestion.hint(name, names));
        }
    }

    private void checkLinks(Block block, LightAttribute<ShapeLinks> attribute) {
        Block.Entry entry = block.entry(attribute.name());
        if (entry != null && entry.value() instanceof Value.LinkSet(ShapeLinks links)) {
            for (int i = 0; i < links.names().size(); i++) {
                String name = links.names().get(i);
                checkNode(block, attribute, name, entry.from() + 1 + i);
            }
        }
    }

    private void checkGains(Block block) {
        Block.Entry entry = block.entry(LightAttribute.GAINS.name());
        if (entry != null && entry.value() instanceof Value.Gains(ShapeGains gains)) {
            for (int i = 0; i < gains.names().size(); i++) {
                checkNode(block, LightAttribute.GAINS, gains.names().get(i), entry.from() + 2 * i);
            }
        }
    }

    /** Adds a problem if there is no shape or group of the name at a token. */
    private void checkNode(Block block, LightAttribute<?> attribute, String name, int token) {
        if (!isNode(name)) {
            problems.add(tokens.start(token), block.title() + ": " + attribute.name() + ": there is no shape or group " + Quote.of(name)
                    + NameSuggestion.hint(name, blocksByName.keySet().stream().filter(this::isNode).toList()));
        }
    }

    /** Adds a problem if the shape that shines does not exist. A group is allowed, as for links; it is dark. */
    private void checkShape(Block block) {
        Block.Entry entry = block.entry(LightAttribute.SHAPE.name());
        if (entry != null && entry.value() instanceof Value.Name(String name)) {
            checkNode(block, LightAttribute.SHAPE, name, entry.from());
        }
    }

    private boolean isNode(String name) {
        Block block = blocksByName.get(name);
        return block == null ? stage.hasNode(name) : BlockTypes.NODE_KEYWORDS.contains(block.type.keyword());
    }

    private void checkUnique(Map<String, Block> blocks, Block block) {
        Block other = block.name.isEmpty() ? null : blocks.putIfAbsent(block.name, block);
        if (other != null) {
            problem(block, block.title() + ": names must be unique, found a " + other.type.keyword() + " with this name before");
        }
    }

    /** Builds the record of a block; empty if a problem prevents it. */
    private <T> Optional<T> buildRecord(Block block, BlockType<T> type, List<SceneNode> children) {
        for (TextureProperty textureProperty : TextureProperty.of(type)) {
            for (String dependent : textureProperty.dependents()) {
                Block.Entry entry = block.entry(dependent);
                if (entry != null && !block.isWritten(textureProperty.name())) {
                    problems.add(tokens.start(entry.nameToken()), block.title() + ": " + textureProperty.missingMessage(dependent));
                }
            }
        }
        if (block.type == BlockTypes.MATERIAL) {
            checkModel(block);
        }
        Map<LoadedAssets.TextureKey, Texture> loadedTextures = new HashMap<>();
        Set<String> unusable = new HashSet<>();
        boolean hasAllTextures = loadTextures(block, loadedTextures, unusable);
        Photometry profile = loadOptional(block, LightAttribute.PROFILE.name(), profiles::load, unusable);
        EnvironmentMap environment = loadOptional(block, World.ENVIRONMENT.name(),
                name -> environments.load(name, environmentMaps, note -> noteReduction(block, World.ENVIRONMENT.name(), note)),
                unusable);
        if (environment != null) {
            environmentMaps.add(environment);
        }
        Mesh mesh = loadMesh(block);
        if (!problems.isEmpty() && (type.isNamed() && block.name.isEmpty()
                || type.header().filter(p -> block.entry(p.name()) == null).isPresent()
                || !hasAllTextures
                || block.isWritten(BlockTypes.FILE) && mesh == null)) {
            return Optional.empty();
        }
        try {
            return Optional
                    .of(type.builder().build(block.name,
                            new PropertyValues(property -> unusable.contains(property) ? null : block.value(property),
                                    new LoadedAssets(loadedTextures, profile, environment, mesh)),
                            children));
        } catch (RefusalException e) {
            problem(block, block.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    private void checkModel(Block material) {
        Block.Entry modelEntry = material.entry(MaterialAttribute.MODEL.name());
        ShadingModel model = modelEntry == null ? MaterialAttribute.MODEL.initial()
                : ((ChoiceKind<ShadingModel>) MaterialAttribute.MODEL.kind()).parse(((Value.Word) modelEntry.value()).text());
        for (MaterialAttribute<?> attribute : MaterialAttribute.ALL) {
            Block.Entry entry = material.entry(attribute.name());
            if (entry != null) {
                attribute.inactiveReason(model)
                        .ifPresent(reason -> problems.add(tokens.start(entry.nameToken()), material.title() + ": " + reason));
            }
        }
    }

    /**
     * Loads the textures of a block; returns false if the value of any is not a file.
     *
     * @param unusable receives the properties whose files cannot be used
     */
    private boolean loadTextures(Block block, Map<LoadedAssets.TextureKey, Texture> loadedTextures, Set<String> unusable) {
        boolean areFiles = true;
        for (TextureProperty textureProperty : TextureProperty.of(block.type)) {
            String property = textureProperty.name();
            Block.Entry entry = block.entry(property);
            if (entry != null && entry.value() instanceof Value.Quoted(String file)) {
                Texture texture = loadOptional(block, property,
                        name -> textures.load(name, textureProperty.samples(),
                                note -> noteReduction(block, property, note)),
                        unusable);
                if (texture != null) {
                    loadedTextures.put(new LoadedAssets.TextureKey(file, textureProperty.samples()), texture);
                }
            } else {
                areFiles &= !block.isWritten(property);
            }
        }
        return areFiles;
    }

    private void noteReduction(Block block, String property, String note) {
        notes.reduce(tokens.start(requireNonNull(block.entry(property)).from()), block.title() + ": " + note);
    }

    /** Returns the mesh of a block; {@link Mesh#MISSING} if it cannot be used; null if the block has no file. */
    private @Nullable Mesh loadMesh(Block block) {
        Block.Entry part = block.entry(BlockTypes.PART);
        Set<String> unusable = new HashSet<>();
        Mesh mesh = loadOptional(block, BlockTypes.FILE,
                file -> meshes.load(file, part == null ? "" : ((Value.Name) part.value()).name()), unusable);
        return unusable.isEmpty() ? mesh : Mesh.MISSING;
    }

    /**
     * Loads the asset that a property references; null if it references none, or the asset cannot be used. That is noted, and the property
     * added to {@code unusable}.
     */
    private <T> @Nullable T loadOptional(Block block, String property, AssetLoader<T> loader, Set<String> unusable) {
        Block.Entry entry = block.entry(property);
        if (entry == null) {
            return null;
        }
        String file = ((Value.Quoted) entry.value()).file();
        try {
            return loader.load(file);
        } catch (UnusableFileException e) {
            notes.leaveOut(tokens.start(entry.from()), new LeftOutFile(property, file), block.title() + ": " + e.getMessage());
            unusable.add(property);
            return null;
        }
    }

    private interface AssetLoader<T> {
        T load(String file) throws UnusableFileException;
    }

    /** Loaded assets of one block. */
    private record LoadedAssets(Map<TextureKey, Texture> textures, @Nullable Photometry photometry, @Nullable EnvironmentMap environmentMap,
            @Nullable Mesh mesh)
            implements AssetSource {
        record TextureKey(String file, TextureUsage samples) {}

        @Override
        public Texture texture(String file, TextureUsage samples) {
            return requireNonNull(textures.get(new TextureKey(file, samples)));
        }

        @Override
        public Photometry profile(String file) {
            return requireNonNull(photometry);
        }

        @Override
        public EnvironmentMap environment(String file) {
            return requireNonNull(environmentMap);
        }

        @Override
        public Mesh mesh(String file, String part) {
            return requireNonNull(mesh);
        }
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.problemToken()), message);
    }
}
