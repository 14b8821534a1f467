package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Vec3;
import lightning.base.text.Quote;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Choice;
import lightning.scene.Glare;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Limits;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Mesh;
import lightning.scene.Node;
import lightning.scene.Photometry;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.SampleMeaning;
import lightning.scene.Scene;
import lightning.scene.Sky;
import lightning.scene.Stage;
import lightning.scene.SurfaceModel;
import lightning.scene.Texture;
import lightning.scene.World;

/** Makes the scene from the blocks of a file and finds what is wrong between blocks. */
final class SceneBuilder {
    private final Tokens tokens;
    private final Problems problems;
    private final TextureFolder textures;
    private final ProfileFolder profiles;
    private final SkyFolder skies;
    private final MeshFolder meshes;
    private final Map<String, Block> named = new HashMap<>();
    private final Set<String> materialNames = new LinkedHashSet<>();
    private final Set<String> bankNames = new LinkedHashSet<>();
    /** Banks that lights may belong to though no block says them. */
    private final List<Bank> known;
    /** Shapes that lights may be linked to though no block says them. */
    private final Stage stage;
    private int shapes;

    /**
     * @param files those that the scene may name
     * @param known banks that lights may belong to though no block says them
     * @param stage shapes that they may be linked to likewise
     */
    SceneBuilder(Tokens tokens, Problems problems, LoadedFiles files, List<Bank> known, Stage stage) {
        this.stage = stage;
        this.known = known;
        this.tokens = tokens;
        this.problems = problems;
        textures = files.textures();
        profiles = files.profiles();
        skies = files.skies();
        meshes = files.meshes();
    }

    /** The scene, or nothing where there are problems. */
    Optional<Scene> build(List<Block> blocks) {
        List<Block> nodeBlocks = blocks.stream().filter(b -> Blocks.NODES.contains(b.type.keyword())).toList();
        List<Block> others = blocks.stream().filter(b -> !Blocks.NODES.contains(b.type.keyword())).toList();
        Optional<Picture> picture = single(others, Blocks.PICTURE);
        Optional<Camera> camera = single(others, Blocks.CAMERA);
        Optional<World> world = single(others, Blocks.WORLD);
        single(others, Blocks.SHOT);
        List<Material> materials = materials(of(others, Blocks.MATERIAL));
        List<Node> nodes = nodes(nodeBlocks, 1, 1);
        List<Bank> banks = banks(of(others, Blocks.BANK));
        List<Light> lights = lights(of(others, Blocks.LIGHT));
        if (!problems.isEmpty()) {
            return Optional.empty();
        }
        var stage = new Stage(materials, nodes);
        Rig rig = Rig.of(lights, banks);
        Glare.of(stage, rig).ifPresent(glare -> problem(named.get(glare.light().name()), glare.message()));
        return problems.isEmpty() ? Optional.of(new Scene(picture.orElse(Picture.DEFAULT), camera.orElse(Camera.DEFAULT),
                world.orElse(World.DEFAULT), stage, rig)) : Optional.empty();
    }

    private static List<Block> of(List<Block> blocks, BlockType<?> type) {
        return blocks.stream().filter(b -> b.type == type).toList();
    }

    private <T> Optional<T> single(List<Block> blocks, BlockType<T> type) {
        List<Block> all = of(blocks, type);
        all.stream().skip(1).forEach(b -> problem(b, b.title() + " must be written once, found it again"));
        return all.isEmpty() ? Optional.empty() : record(all.getFirst(), type, List.of());
    }

    private List<Material> materials(List<Block> blocks) {
        List<Material> materials = new ArrayList<>();
        materialNames.add(Material.DEFAULT.name());
        Map<String, Block> known = new HashMap<>();
        for (Block block : blocks) {
            unique(known, block);
            materialNames.add(block.name);
            record(block, Blocks.MATERIAL, List.of()).ifPresent(materials::add);
        }
        count(blocks, Limits.MAX_MATERIALS, "materials");
        return materials;
    }

    private List<Bank> banks(List<Block> blocks) {
        List<Bank> banks = new ArrayList<>(known);
        known.forEach(bank -> bankNames.add(bank.name()));
        for (Block block : blocks) {
            unique(named, block);
            bankNames.add(block.name);
            record(block, Blocks.BANK, List.of()).ifPresent(banks::add);
        }
        count(blocks, Limits.MAX_BANKS, "banks");
        return banks;
    }

    private List<Light> lights(List<Block> blocks) {
        List<Light> lights = new ArrayList<>();
        for (Block block : blocks) {
            unique(named, block);
            checkNamed(block, "bank", bankNames);
            checkLinks(block, LightAttribute.ILLUMINATES);
            checkLinks(block, LightAttribute.SHADOWED_BY);
            record(block, Blocks.LIGHT, List.of()).ifPresent(lights::add);
        }
        count(blocks, Limits.MAX_LIGHTS, "lights");
        return lights;
    }

    private void count(List<Block> blocks, int most, String what) {
        if (blocks.size() > most) {
            problem(blocks.get(most), "a scene may have at most " + most + " " + what + ", found " + blocks.size());
        }
    }

    /**
     * @param least the product of the smallest scale factors of the groups around
     * @param most  the product of the largest
     */
    private List<Node> nodes(List<Block> blocks, double least, double most) {
        List<Node> nodes = new ArrayList<>();
        for (Block block : blocks) {
            unique(named, block);
            Placement scale = scale(block);
            double smallest = least * scale.leastScale();
            double largest = most * scale.mostScale();
            try {
                Limits.combinedScale(block::title, smallest, largest);
            } catch (IllegalArgumentException e) {
                problem(block, e.getMessage());
            }
            if (block.type != Blocks.GROUP) {
                checkNamed(block, "material", materialNames);
                if (++shapes == Limits.MAX_SHAPES + 1) {
                    problem(block, "a scene may have at most " + Limits.MAX_SHAPES + " shapes");
                }
            }
            List<Node> children = nodes(block.children, smallest, largest);
            record(block, block.type, children).ifPresent(n -> nodes.add((Node) n));
        }
        return nodes;
    }

    private static Placement scale(Block block) {
        Block.Entry entry = block.entry("scale");
        return entry == null ? Placement.IDENTITY
                : new Placement(Vec3.ZERO, Vec3.ZERO, new Values(block::value, null).vector("scale"));
    }

    /** @param property says what is named, and is called like it */
    private void checkNamed(Block block, String property, Set<String> names) {
        Block.Entry entry = block.entry(property);
        if (entry != null && entry.value() instanceof Value.Name(String name) && !names.contains(name)) {
            problems.add(tokens.start(entry.from()), block.title() + ": there is no " + property + " " + Quote.of(name)
                    + Nearest.hint(name, names));
        }
    }

    private void checkLinks(Block block, LightAttribute<Links> attribute) {
        Block.Entry entry = block.entry(attribute.name());
        if (entry != null && entry.value() instanceof Value.Linked(Links links)) {
            for (int i = 0; i < links.names().size(); i++) {
                String name = links.names().get(i);
                if (!isNode(name)) {
                    problems.add(tokens.start(entry.from() + 1 + i),
                            block.title() + ": " + attribute.name() + ": there is no shape or group "
                                    + Quote.of(name) + Nearest.hint(name, named.keySet().stream().filter(this::isNode).toList()));
                }
            }
        }
    }

    private boolean isNode(String name) {
        Block block = named.get(name);
        return block == null ? stage.hasNode(name) : Blocks.NODES.contains(block.type.keyword());
    }

    private void unique(Map<String, Block> known, Block block) {
        Block other = block.name.isEmpty() ? null : known.putIfAbsent(block.name, block);
        if (other != null) {
            problem(block, block.title() + ": names must be unique, found a " + other.type.keyword() + " with this name before");
        }
    }

    /** The record of a block; nothing where a problem of the file stands in the way. */
    private <T> Optional<T> record(Block block, BlockType<T> type, List<Node> children) {
        for (PictureProperty picture : PictureProperty.ALL) {
            Block.Entry repeat = picture.repeat().map(block::entry).orElse(null);
            if (repeat != null && !block.isWritten(picture.name())) {
                problems.add(tokens.start(repeat.nameToken()), block.title() + ": " + picture.missing());
            }
        }
        if (block.type == Blocks.MATERIAL) {
            ofOneModel(block);
        }
        Map<Loaded.Picture, Texture> pictures = new HashMap<>();
        boolean hasAll = load(block, pictures);
        Photometry profile = loaded(block, LightAttribute.PROFILE.name(), profiles::load);
        Sky sky = loaded(block, World.ENVIRONMENT.name(), skies::load);
        Mesh mesh = mesh(block);
        if (!problems.isEmpty() && (type.named() && block.name.isEmpty()
                || type.header().filter(p -> block.entry(p.name()) == null).isPresent()
                || !hasAll
                || block.isWritten(LightAttribute.PROFILE.name()) && profile == null
                || block.isWritten(World.ENVIRONMENT.name()) && sky == null
                || block.isWritten(Blocks.FILE) && mesh == null)) {
            return Optional.empty();
        }
        try {
            return Optional
                    .of(type.builder().build(block.name, new Values(block::value, new Loaded(pictures, profile, sky, mesh)), children));
        } catch (IllegalArgumentException e) {
            problem(block, block.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    private void ofOneModel(Block material) {
        Block.Entry written = material.entry(MaterialAttribute.MODEL.name());
        SurfaceModel model = written == null ? MaterialAttribute.MODEL.initial()
                : ((Choice<SurfaceModel>) MaterialAttribute.MODEL.kind()).value(((Value.Word) written.value()).text());
        for (MaterialAttribute<?> attribute : MaterialAttribute.ALL) {
            Block.Entry entry = material.entry(attribute.name());
            if (entry != null) {
                attribute.obstacle(model).ifPresent(why -> problems.add(tokens.start(entry.nameToken()), material.title() + ": " + why));
            }
        }
    }

    /** Reads the pictures that a block names; whether all of them could be. */
    private boolean load(Block block, Map<Loaded.Picture, Texture> pictures) {
        boolean all = true;
        for (PictureProperty picture : PictureProperty.ALL) {
            Block.Entry entry = block.entry(picture.name());
            if (entry != null && entry.value() instanceof Value.Quoted(String file)) {
                Texture texture = loaded(block, picture.name(), name -> textures.load(name, picture.samples()));
                pictures.put(new Loaded.Picture(file, picture.samples()), texture);
                all &= texture != null;
            } else {
                all &= !block.isWritten(picture.name());
            }
        }
        return all;
    }

    private Mesh mesh(Block block) {
        Block.Entry part = block.entry(Blocks.PART);
        return loaded(block, Blocks.FILE, file -> meshes.load(file, part == null ? "" : ((Value.Name) part.value()).name()));
    }

    private interface Loading<T> {
        T of(String file) throws UnusableFileException;
    }

    /** What the file holds that a property of a block names; null where it names none, or none that can be used. */
    private <T> T loaded(Block block, String property, Loading<T> loading) {
        Block.Entry entry = block.entry(property);
        if (entry == null) {
            return null;
        }
        try {
            return loading.of(((Value.Quoted) entry.value()).file());
        } catch (UnusableFileException e) {
            problems.add(tokens.start(entry.from()), block.title() + ": " + e.getMessage());
            return null;
        }
    }

    /** What the files of one block hold. */
    private record Loaded(Map<Picture, Texture> pictures, Photometry photometry, Sky panorama, Mesh mesh) implements SceneFiles {
        record Picture(String file, SampleMeaning samples) {}

        @Override
        public Texture texture(String file, SampleMeaning samples) {
            return pictures.get(new Picture(file, samples));
        }

        @Override
        public Photometry profile(String file) {
            return photometry;
        }

        @Override
        public Sky sky(String file) {
            return panorama;
        }

        @Override
        public Mesh mesh(String file, String part) {
            return mesh;
        }
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.place()), message);
    }
}
